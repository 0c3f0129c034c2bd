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
inline constexpr double kConvexNoise = 1e-3;     // a gap this part of the bound on its error is 0
// Fraction of the range; a least value this far outside counts, too.
inline constexpr double kConvexBorder = 1e-9;
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

/// What is known of the gap of two curves where it is proven convex.
struct ConvexGap {
  double tolerance;   ///< least values up to this count as touches, model units
  double error;       ///< bound on the error of a gap, model units
  double least_bend;  ///< of the second derivative by x; positive
  double most_bend;
  double stretch = 1;  ///< bound on the length along the curves over a unit of x, model units
  /// Where the gap ends above 0 or below it, this far at least, nothing else brings the curves
  /// together.
  double beyond = 0;
};

/// The zeros of a convex gap and its least value within tolerance, all there are between two sides.
///
/// at       makes a side from x and a side near it
/// add      takes a side and whether it is a touch, else a zero; false: it is not decided
/// returns  false if it is not decided
template <class Side, class At, class Add>
bool convex_points(const Side& low, const Side& high, const ConvexGap& known, At at, Add add) {
  const auto from = [&](const Side& first) {
    return [&at, last = first](double x) mutable { return last = at(x, last); };
  };
  const auto add_zero = [&](const Side& side, const Side& least) {
    if (side.gap < -known.error) return true;
    if (side.gap <= known.error) return add(side, false);
    return add(zero_between(side, least, from(side), detail::kConvexNoise * known.error), false);
  };
  const double slack = known.most_bend * detail::kConvexBorder * (high.x - low.x);
  if (high.slope > -slack && low.slope < slack) {
    const Side bottom = least_between(low, high, from(low));
    if (bottom.gap > known.tolerance + known.error) return true;
    const double depth = std::max(0.0, -bottom.gap - known.error);
    const double apart = 2 * std::sqrt(2 * depth / known.least_bend) * known.stretch;
    if (bottom.gap >= -known.error || apart <= known.tolerance) return add(bottom, true);
    return add_zero(low, bottom) && add_zero(high, bottom);
  }
  const bool grows = low.slope >= slack;
  const Side &lower = grows ? low : high, &upper = grows ? high : low;
  if (lower.gap > known.error) return lower.gap > known.beyond + known.error;
  if (upper.gap < -known.error) return upper.gap < -known.beyond - known.error;
  if (lower.gap >= -known.error) return add(lower, false);
  return add_zero(upper, lower);
}

}  // namespace blossom
