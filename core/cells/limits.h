// SPDX-License-Identifier: LGPL-2.1-or-later
// Where cells are cut, for all searches.

#pragma once

namespace blossom {

/// Part of a cell's side where it is cut. Singular points and symmetric shapes like dyadic
/// parameters, and a stationary point on a border would be searched from both sides: a choice off
/// 1/2. It has six binary digits, so that eight cuts in a row are exact; the lower piece is shorter
/// by a thirty-second, which costs no depth.
inline constexpr double kOffMiddle = 31.0 / 64;

/// Likewise where cells of two surfaces are cut, and where patches are divided before they are
/// searched. A choice: cells of a curve and of a surface, or knots of refined nets, that were cut
/// at `kOffMiddle` are then not met again.
inline constexpr double kSurfaceOffMiddle = 0.4865;

}  // namespace blossom
