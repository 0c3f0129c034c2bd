// SPDX-License-Identifier: LGPL-2.1-or-later
// Zeros and the least value of a strictly convex function of one variable, whose second derivative
// is bounded. Such functions are the gaps of valleys, of two curves or of a curve and a surface.
//
// A `Side` is the function at a place: at least {x, gap, slope, bend}, with bend clamped between
// the proven bounds; `at(x)` makes one.

#pragma once

#include <algorithm>
#include <cmath>

namespace blossom {

namespace detail {
inline constexpr int kConvexSteps = 60;          // of the safeguarded searches
inline constexpr double kConvexSettled = 1e-13;  // steps this small, as part of the range, are last
}  // namespace detail

/// The place of the least value between two sides whose slopes have different signs.
template <class Side, class At>
Side least_between(Side low, Side high, const At& at) {
  Side side = low.slope > -high.slope ? high : low;
  const double width = high.x - low.x;
  for (int k = 0; k < detail::kConvexSteps; ++k) {
    double x = side.x - side.slope / side.bend;
    if (!(x > low.x && x < high.x)) x = 0.5 * (low.x + high.x);
    if (x == side.x || !(x > low.x && x < high.x)) break;
    const double moved = std::abs(x - side.x);
    side = at(x);
    (side.slope < 0 ? low : high) = side;
    if (moved <= detail::kConvexSettled * width) break;
  }
  return side;
}

/// The zero between a side with gap above 0 and one with gap below 0.
///
/// noise   gaps up to this count as 0, model units
template <class Side, class At>
Side zero_between(Side above, Side below, const At& at, double noise) {
  Side side = above;
  const double width = std::abs(above.x - below.x);
  for (int k = 0; k < detail::kConvexSteps; ++k) {
    // On a convex function Newton's steps from above never pass the zero.
    double x = side.gap > 0 && side.slope != 0 ? side.x - side.gap / side.slope
                                               : 0.5 * (above.x + below.x);
    const double low = std::min(above.x, below.x), high = std::max(above.x, below.x);
    if (!(x > low && x < high)) x = 0.5 * (low + high);
    if (x == side.x || !(x > low && x < high)) break;
    const double moved = std::abs(x - side.x);
    side = at(x);
    (side.gap > 0 ? above : below) = side;
    if (moved <= detail::kConvexSettled * width || std::abs(side.gap) <= noise) break;
  }
  return side;
}

}  // namespace blossom
