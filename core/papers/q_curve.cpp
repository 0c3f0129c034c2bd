// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/papers/q_curve.h"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>

#include "core/blossom/detail/checks.h"
#include "core/papers/detail/q_checks.h"
#include "core/papers/detail/q_conversion.h"
#include "core/papers/detail/q_errors.h"

namespace blossom {
namespace {

template <class Point>
void check(const char* function, const QBezierCurveOf<Point>& curve) {
  detail::check_basis(function, curve.degree(), curve.interval, curve.q);
  detail::check_points(function, std::span<const Point>(curve.points));
}

}  // namespace

template <class Point>
Point point_at(const QBezierCurveOf<Point>& curve, const ScalarOf<Point>& x) {
  check("point_at", curve);
  detail::check_finite("point_at", "x", x);
  return detail::evaluation_levels(curve.points, curve.interval, curve.q, x,
                                   identity_permutation(curve.degree()))
      .back()[0];
}

template <class Point>
QBezierCurveOf<Point> q_bezier_form(const MonomialCurveOf<Point>& curve,
                                    const IntervalOf<ScalarOf<Point>>& interval,
                                    const QParametersOf<ScalarOf<Point>>& q) {
  return {q_control_points(curve, interval, q), interval, q};
}

template <class Point>
QBezierCurveOf<Point> q_bezier_form(const BezierCurveOf<Point>& curve,
                                    const IntervalOf<ScalarOf<Point>>& interval,
                                    const QParametersOf<ScalarOf<Point>>& q) {
  detail::check_basis("q_bezier_form", curve.degree(), interval, q);
  detail::check_points("q_bezier_form", std::span<const Point>(curve.points));
  return {detail::solution(detail::conversion_matrix(curve.degree(), interval, q), curve.points),
          interval, q};
}

template <class Point>
MonomialCurveOf<Point> monomial_form(const QBezierCurveOf<Point>& curve) {
  check("monomial_form", curve);
  return {detail::monomial_coefficients(curve.points, curve.interval, curve.q)};
}

template <class Point>
BezierCurveOf<Point> bezier_form(const QBezierCurveOf<Point>& curve) {
  check("bezier_form", curve);
  return {
      product(detail::conversion_matrix(curve.degree(), curve.interval, curve.q), curve.points)};
}

template <class Scalar>
Grid<Scalar> q_conversion_matrix(int n, const IntervalOf<Scalar>& interval,
                                 const QParametersOf<Scalar>& q) {
  detail::check_basis("q_conversion_matrix", n, interval, q);
  return detail::conversion_matrix(n, interval, q);
}

template <class Point>
double bezier_form_error(const QBezierCurveOf<Point>& curve) {
  check("bezier_form_error", curve);
  std::vector<Point> sizes;
  for (const Point& point : curve.points) sizes.push_back(detail::absolute(point));
  double largest = 0;
  for (const Point& point :
       product(detail::conversion_sizes(curve.degree(), curve.interval, curve.q), sizes))
    largest = std::max(largest, max_norm(point));
  return q_conversion_error(curve.degree()) * largest;
}

using Rational = boost::multiprecision::cpp_rational;
using ExactPoint2 = Vec<Rational, 2>;
using ExactPoint3 = Vec<Rational, 3>;
using ExactPoint4 = Vec<Rational, 4>;

#define BLOSSOM_INSTANTIATE(Point)                                                     \
  template Point point_at(const QBezierCurveOf<Point>&, const ScalarOf<Point>&);       \
  template QBezierCurveOf<Point> q_bezier_form(const MonomialCurveOf<Point>&,          \
                                               const IntervalOf<ScalarOf<Point>>&,     \
                                               const QParametersOf<ScalarOf<Point>>&); \
  template QBezierCurveOf<Point> q_bezier_form(const BezierCurveOf<Point>&,            \
                                               const IntervalOf<ScalarOf<Point>>&,     \
                                               const QParametersOf<ScalarOf<Point>>&); \
  template MonomialCurveOf<Point> monomial_form(const QBezierCurveOf<Point>&);         \
  template BezierCurveOf<Point> bezier_form(const QBezierCurveOf<Point>&);
BLOSSOM_INSTANTIATE(Vec2)
BLOSSOM_INSTANTIATE(Vec3)
BLOSSOM_INSTANTIATE(Vec4)
BLOSSOM_INSTANTIATE(ExactPoint2)
BLOSSOM_INSTANTIATE(ExactPoint3)
BLOSSOM_INSTANTIATE(ExactPoint4)
#undef BLOSSOM_INSTANTIATE

template Grid<double> q_conversion_matrix(int, const Interval&, const QParameters&);
template Grid<Rational> q_conversion_matrix(int, const IntervalOf<Rational>&,
                                            const QParametersOf<Rational>&);
template double bezier_form_error(const QBezierCurveOf<Vec2>&);
template double bezier_form_error(const QBezierCurveOf<Vec3>&);
template double bezier_form_error(const QBezierCurveOf<Vec4>&);

}  // namespace blossom
