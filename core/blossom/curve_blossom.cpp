// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blossom/curve_blossom.h"

#include <algorithm>
#include <vector>

#include "core/blossom/detail/checks.h"
#include "core/blossom/detail/closed_form.h"
#include "core/forms/detail/checks.h"

namespace blossom {
namespace {

template <class Point>
void check(const char* function, const MonomialCurveOf<Point>& curve) {
  detail::check_degree(function, curve.degree());
  detail::check_placement(function, curve.centre, curve.scale);
}

}  // namespace

template <class Point>
Point blossom_at(const MonomialCurveOf<Point>& curve, std::span<const double> parameters) {
  check("blossom_at", curve);
  detail::check_parameters("blossom_at", "curve", curve.degree(), parameters);
  const std::vector<double> local = detail::local_parameters(parameters, curve.centre, curve.scale);
  const std::vector<double> weights = detail::monomial_blossoms(std::span(local));
  Point sum = curve.coefficients[0] * weights[0];
  for (std::size_t i = 1; i < weights.size(); ++i) sum += curve.coefficients[i] * weights[i];
  return sum;
}

template <class Point>
Point blossom_at(const BezierCurveOf<Point>& curve, std::span<const double> parameters) {
  detail::check_degree("blossom_at", curve.degree());
  detail::check_parameters("blossom_at", "curve", curve.degree(), parameters);
  return detail::casteljau_blossom(curve.points, parameters);
}

template <class Point>
BezierCurveOf<Point> bezier_points(const MonomialCurveOf<Point>& curve, const Interval& interval) {
  check("bezier_points", curve);
  detail::check_interval("bezier_points", "of the curve", interval);
  return {detail::bezier_line(curve, interval)};
}

template <class Point>
double blossom_scale(const MonomialCurveOf<Point>& curve, const Interval& interval) {
  check("blossom_scale", curve);
  detail::check_interval("blossom_scale", "of the curve", interval);
  const Interval local = detail::local_interval(interval, curve.centre, curve.scale);
  MonomialCurveOf<Point> sizes{curve.coefficients};
  for (Point& point : sizes.coefficients) point = detail::absolute(point);
  double largest = 0;
  for (const Point& point : detail::bezier_line(sizes, detail::absolute(local)))
    largest = std::max(largest, max_norm(point));
  return largest;
}

#define BLOSSOM_INSTANTIATE(Point)                                                             \
  template Point blossom_at(const MonomialCurveOf<Point>&, std::span<const double>);           \
  template Point blossom_at(const BezierCurveOf<Point>&, std::span<const double>);             \
  template BezierCurveOf<Point> bezier_points(const MonomialCurveOf<Point>&, const Interval&); \
  template double blossom_scale(const MonomialCurveOf<Point>&, const Interval&);
BLOSSOM_INSTANTIATE(Vec2)
BLOSSOM_INSTANTIATE(Vec3)
BLOSSOM_INSTANTIATE(Vec4)
#undef BLOSSOM_INSTANTIATE

}  // namespace blossom
