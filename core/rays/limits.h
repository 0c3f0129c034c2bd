// SPDX-License-Identifier: LGPL-2.1-or-later
// What searches for roots of two forms decide in the same way: hits of lines, and feet of points.
// Parts are of a region's sides.

#pragma once

namespace blossom {

/// Roots this little outside of a region belong to it, too; the neighbour finds the same one. A
/// choice far above what rounding leaves of a regular root, some 1e-15 times the condition of the
/// two equations, and far below `kPlaceable`.
inline constexpr double kRootSlack = 1e-9;

/// Values must be this exact, in parameters of the region, for a root to be placed in it. A choice:
/// what is less exact is halved on, and a region has to be wider than its slack on both sides.
inline constexpr double kPlaceable = 1e-3;

}  // namespace blossom
