// SPDX-License-Identifier: LGPL-2.1-or-later
// What several steps decide in the same way about what lies on two surfaces.

#pragma once

namespace blossom::occt {

/// Tolerances: what is so near to a surface, a region or a curve lies on it. A choice: curves and
/// surfaces are each off by a tolerance or two, and where they run beside each other by a few.
inline constexpr double kOnIt = 10;

/// Of the size of faces or of their common box: how far a line goes on past it. A choice: enough
/// for tolerances and roundings, and too little to matter in a search.
inline constexpr double kBeyondBox = 1e-2;

}  // namespace blossom::occt
