// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/papers/q_blossom.h"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <numeric>

#include "core/blossom/detail/checks.h"
#include "core/papers/detail/q_blossom.h"
#include "core/papers/detail/q_checks.h"
#include "core/papers/detail/q_errors.h"

namespace blossom {
namespace {

using detail::index;

template <class Point>
void check(const char* function, const MonomialCurveOf<Point>& curve,
           const QParametersOf<ScalarOf<Point>>& q) {
  detail::check_blossom(function, curve.degree(), q);
  detail::check_points(function, std::span<const Point>(curve.coefficients));
  detail::check_placement(function, curve.centre, curve.scale);
  detail::check_divisors(function, curve.degree(), q);
}

template <class Scalar>
void check_c(const char* function, const Scalar& c) {
  detail::check_finite(function, "c", c);
  if (c == 0) throw InvalidInput(std::string(function) + ": c must not be 0");
}

template <class Point>
int degree(const std::vector<Point>& points) {
  return static_cast<int>(points.size()) - 1;
}

template <class Point>
void check(const char* function, const std::vector<Point>& points,
           const IntervalOf<ScalarOf<Point>>& interval, const QParametersOf<ScalarOf<Point>>& q) {
  detail::check_basis(function, degree(points), interval, q);
  detail::check_points(function, std::span<const Point>(points));
}

}  // namespace

template <class Point>
Point q_blossom_at(const MonomialCurveOf<Point>& curve, const QParametersOf<ScalarOf<Point>>& q,
                   std::span<const PairOf<Point>> arguments) {
  check("q_blossom_at", curve, q);
  detail::check_arguments("q_blossom_at", curve.degree(), arguments);
  return detail::homogeneous_blossom(detail::plain_coefficients(curve),
                                     detail::diagonal_factors(curve.degree(), q), arguments);
}

template <class Point>
double q_blossom_scale(const MonomialCurveOf<Point>& curve, const QParameters& q,
                       std::span<const Vec2> arguments) {
  check("q_blossom_scale", curve, q);
  detail::check_arguments("q_blossom_scale", curve.degree(), arguments);
  const int n = curve.degree();
  const QParameters sizes{std::abs(q.q1), std::abs(q.q2)};
  const std::vector<double> rows = detail::q_binomial_row(n, q);
  const std::vector<double> row_sizes = detail::q_binomial_row(n, sizes);
  std::vector<double> divisors = detail::diagonal_factors(n, sizes);
  // An error of [n,k] relative to its size becomes one relative to itself.
  for (int k = 0; k <= n; ++k) {
    const double loss = row_sizes[index(k)] / std::abs(rows[index(k)]);
    divisors[index(k)] /= loss * loss;
  }
  std::vector<Vec2> argument_sizes;
  for (const Vec2& pair : arguments) argument_sizes.push_back(detail::absolute(pair));
  std::vector<Point> coefficients = detail::plain_coefficients(curve);
  for (Point& point : coefficients) point = detail::absolute(point);
  return max_norm(
      detail::homogeneous_blossom(coefficients, divisors, std::span<const Vec2>(argument_sizes)));
}

template <class Point>
std::vector<Point> q_control_points(const MonomialCurveOf<Point>& curve,
                                    const IntervalOf<ScalarOf<Point>>& interval,
                                    const QParametersOf<ScalarOf<Point>>& q,
                                    const ScalarOf<Point>& c) {
  check("q_control_points", curve, q);
  detail::check_basis("q_control_points", curve.degree(), interval, q);
  check_c("q_control_points", c);
  return detail::control_points(detail::plain_coefficients(curve), interval, q, c);
}

template <class Scalar>
std::vector<Vec<Scalar, 2>> q_control_arguments(int n, int k, const IntervalOf<Scalar>& interval,
                                                const QParametersOf<Scalar>& q, const Scalar& c) {
  detail::check_degree("q_control_arguments", n);
  detail::check_q("q_control_arguments", q);
  check_c("q_control_arguments", c);
  detail::check_finite("q_control_arguments", "the start of the interval", interval.from);
  detail::check_finite("q_control_arguments", "the end of the interval", interval.to);
  if (k < 0 || k > n)
    throw InvalidInput("q_control_arguments: k must be 0.." + std::to_string(n) + ", got " +
                       std::to_string(k));
  return detail::control_arguments(n, k, interval, detail::QFactors<Scalar>(n, q), c);
}

template <class Point>
QLevels<Point> q_blossom_levels(const std::vector<Point>& points,
                                const IntervalOf<ScalarOf<Point>>& interval,
                                const QParametersOf<ScalarOf<Point>>& q,
                                std::span<const PairOf<Point>> arguments,
                                const ScalarOf<Point>& c) {
  const int n = degree(points);
  check("q_blossom_levels", points, interval, q);
  check_c("q_blossom_levels", c);
  detail::check_arguments("q_blossom_levels", n, arguments);
  const detail::QFactors<ScalarOf<Point>> factors(n, q);
  return detail::triangle_levels(points, [&](int r, int k) {
    return detail::blossom_step(factors, interval, c, arguments[index(r)], r, k);
  });
}

template <class Point>
QLevels<Point> q_evaluation_levels(const std::vector<Point>& points,
                                   const IntervalOf<ScalarOf<Point>>& interval,
                                   const QParametersOf<ScalarOf<Point>>& q,
                                   const ScalarOf<Point>& x, std::span<const int> permutation) {
  check("q_evaluation_levels", points, interval, q);
  detail::check_finite("q_evaluation_levels", "x", x);
  detail::check_permutation("q_evaluation_levels", degree(points), permutation);
  return detail::evaluation_levels(points, interval, q, x, permutation);
}

template <class Point>
double q_evaluation_error(const std::vector<Point>& points, const Interval& interval,
                          const QParameters& q, double x, std::span<const int> permutation) {
  check("q_evaluation_error", points, interval, q);
  detail::check_finite("q_evaluation_error", "x", x);
  detail::check_permutation("q_evaluation_error", degree(points), permutation);
  return detail::evaluation_errors(points, std::vector<double>(points.size(), 0.0), interval, q, x,
                                   permutation)
      .back()[0];
}

template <class Point>
QLevels<Point> classical_levels(const std::vector<Point>& points,
                                const IntervalOf<ScalarOf<Point>>& interval,
                                const ScalarOf<Point>& q, const ScalarOf<Point>& x,
                                std::span<const int> permutation) {
  using Scalar = ScalarOf<Point>;
  const int n = degree(points);
  detail::check_degree("classical_levels", n);
  detail::check_finite("classical_levels", "q", q);
  if (q == 0) throw InvalidInput("classical_levels: q must not be 0");
  check("classical_levels", points, interval, QParametersOf<Scalar>{});
  detail::check_finite("classical_levels", "x", x);
  detail::check_permutation("classical_levels", n, permutation);
  const std::vector<Scalar> power = detail::powers(q, n);
  const Scalar length = interval.to - interval.from;
  const Scalar before = (interval.to - x) / length, after = (x - interval.from) / length;
  return detail::triangle_levels(points, [&](int r, int k) {
    const Scalar& stretch = power[index(permutation[index(r)] - 1)];
    return detail::Step<Scalar>{Scalar(stretch / power[index(r + k)] * before),
                                Scalar(stretch / power[index(k)] * after)};
  });
}

std::vector<int> identity_permutation(int n) {
  detail::check_degree("identity_permutation", n);
  std::vector<int> permutation(index(n));
  std::iota(permutation.begin(), permutation.end(), 1);
  return permutation;
}

std::vector<int> reversed_permutation(int n) {
  std::vector<int> permutation = identity_permutation(n);
  std::reverse(permutation.begin(), permutation.end());
  return permutation;
}

using Rational = boost::multiprecision::cpp_rational;

#define BLOSSOM_INSTANTIATE(Point)                                                           \
  template Point q_blossom_at(const MonomialCurveOf<Point>&,                                 \
                              const QParametersOf<ScalarOf<Point>>&,                         \
                              std::span<const PairOf<Point>>);                               \
  template std::vector<Point> q_control_points(                                              \
      const MonomialCurveOf<Point>&, const IntervalOf<ScalarOf<Point>>&,                     \
      const QParametersOf<ScalarOf<Point>>&, const ScalarOf<Point>&);                        \
  template QLevels<Point> q_blossom_levels(                                                  \
      const std::vector<Point>&, const IntervalOf<ScalarOf<Point>>&,                         \
      const QParametersOf<ScalarOf<Point>>&, std::span<const PairOf<Point>>,                 \
      const ScalarOf<Point>&);                                                               \
  template QLevels<Point> q_evaluation_levels(                                               \
      const std::vector<Point>&, const IntervalOf<ScalarOf<Point>>&,                         \
      const QParametersOf<ScalarOf<Point>>&, const ScalarOf<Point>&, std::span<const int>);  \
  template QLevels<Point> classical_levels(                                                  \
      const std::vector<Point>&, const IntervalOf<ScalarOf<Point>>&, const ScalarOf<Point>&, \
      const ScalarOf<Point>&, std::span<const int>);
using ExactPoint2 = Vec<Rational, 2>;
using ExactPoint3 = Vec<Rational, 3>;
using ExactPoint4 = Vec<Rational, 4>;
BLOSSOM_INSTANTIATE(Vec2)
BLOSSOM_INSTANTIATE(Vec3)
BLOSSOM_INSTANTIATE(Vec4)
BLOSSOM_INSTANTIATE(ExactPoint2)
BLOSSOM_INSTANTIATE(ExactPoint3)
BLOSSOM_INSTANTIATE(ExactPoint4)
#undef BLOSSOM_INSTANTIATE

#define BLOSSOM_INSTANTIATE(Point)                                                   \
  template double q_blossom_scale(const MonomialCurveOf<Point>&, const QParameters&, \
                                  std::span<const Vec2>);                            \
  template double q_evaluation_error(const std::vector<Point>&, const Interval&,     \
                                     const QParameters&, double, std::span<const int>);
BLOSSOM_INSTANTIATE(Vec2)
BLOSSOM_INSTANTIATE(Vec3)
BLOSSOM_INSTANTIATE(Vec4)
#undef BLOSSOM_INSTANTIATE

template std::vector<Vec2> q_control_arguments(int, int, const Interval&, const QParameters&,
                                               const double&);
template std::vector<ExactPoint2> q_control_arguments(int, int, const IntervalOf<Rational>&,
                                                      const QParametersOf<Rational>&,
                                                      const Rational&);

}  // namespace blossom
