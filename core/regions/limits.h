// SPDX-License-Identifier: LGPL-2.1-or-later
// What counts as one place in a surface's parameters, for all steps of a trimmed region.

#pragma once

namespace blossom {

/// Relative to the surface's range of a parameter: borders and corners as near as this to a line
/// between patches lie on it. A choice: models write parameters with ten digits and more, and ends
/// of curves that were computed agree to better than that.
inline constexpr double kOnLine = 1e-9;

/// Likewise: trims as near as kOnLine to both ends of a span count as on either of them.
inline constexpr double kNarrowSpan = 2 * kOnLine;

/// Relative to a border's parameters: no arc is shorter, and stops nearer than this are one, the
/// first of them. Faces with a common border agree on its stops by the same rule. A choice beside
/// kOnLine: a border that is as long as the range has one stop where it crosses a line.
inline constexpr double kShortestArc = 1e-9;

/// Distances in a patch's parameters that are no more than rounding: parameters below 1 round by
/// 1e-16, and a composition of degree 25 in a surface adds some hundred roundings.
inline constexpr double kArcRounding = 1e-13;

}  // namespace blossom
