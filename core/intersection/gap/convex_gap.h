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
Side least_between(Side low, Side high, At at) {
  Side side = low.slope > -high.slope ? high : low;
  const double width = high.x - low.x;
  for (int k = 0; k < detail::kConvexSteps; ++k) {
    const double step = side.slope / side.bend;
    if (std::abs(step) <= detail::kConvexSettled * width) break;
    double x = side.x - step;
    if (!(x > low.x && x < high.x)) x = 0.5 * (low.x + high.x);
    if (!(x > low.x && x < high.x)) break;
    side = at(x);
    (side.slope < 0 ? low : high) = side;
  }
  return side;
}

/// The zero between a side with gap above 0 and one with gap below 0.
///
/// noise   gaps up to this count as 0, model units
template <class Side, class At>
Side zero_between(Side above, Side below, At at, double noise) {
  Side side = above;
  const double width = std::abs(above.x - below.x);
  for (int k = 0; k < detail::kConvexSteps && !(std::abs(side.gap) <= noise); ++k) {
    // The nearer zero of the parabola with the same gap, slope and bend; of the tangent if that has
    // none.
    const double square = side.slope * side.slope - 2 * side.gap * side.bend;
    const double root = std::copysign(std::sqrt(std::max(0.0, square)), side.slope);
    const double step = square >= 0 ? 2 * side.gap / (side.slope + root) : side.gap / side.slope;
    if (std::abs(step) <= detail::kConvexSettled * width) break;
    double x = side.x - step;
    const double low = std::min(above.x, below.x), high = std::max(above.x, below.x);
    if (!(x > low && x < high)) x = 0.5 * (low + high);
    if (!(x > low && x < high)) break;
    side = at(x);
    (side.gap > 0 ? above : below) = side;
  }
  return side;
}

}  // namespace blossom
