// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <string>

#include "core/papers/detail/q_checks.h"
#include "core/papers/detail/q_errors.h"
#include "core/papers/detail/q_subdivision.h"
#include "core/papers/q_curve.h"

namespace blossom {
namespace {

template <class Point>
void check(const char* function, const QBezierCurveOf<Point>& curve, const ScalarOf<Point>& t) {
  detail::check_basis(function, curve.degree(), curve.interval, curve.q);
  detail::check_points(function, std::span<const Point>(curve.points));
  detail::check_finite(function, "the cut", t);
}

}  // namespace

template <class Point>
QCutPoints<Point> q_cut_points(const QBezierCurveOf<Point>& curve, const ScalarOf<Point>& t) {
  check("q_cut_points", curve, t);
  return detail::cut_points(curve.points, curve.interval, curve.q, t);
}

template <class Point>
double q_cut_error(const QBezierCurveOf<Point>& curve, double t) {
  check("q_cut_error", curve, t);
  double largest = 0;
  for (const auto& permutation :
       {identity_permutation(curve.degree()), reversed_permutation(curve.degree())})
    for (const auto& level :
         detail::evaluation_errors(curve.points, std::vector<double>(curve.points.size(), 0.0),
                                   curve.interval, curve.q, t, permutation))
      largest = std::max(largest, *std::max_element(level.begin(), level.end()));
  return largest;
}

template <class Point>
QHalves<Point> subdivide(const QBezierCurveOf<Point>& curve, const ScalarOf<Point>& t) {
  check("subdivide", curve, t);
  const IntervalOf<ScalarOf<Point>> before{curve.interval.from, t}, after{t, curve.interval.to};
  detail::check_basis("subdivide", curve.degree(), before, curve.q);
  detail::check_basis("subdivide", curve.degree(), after, curve.q);
  QCutPoints<Point> points = detail::cut_points(curve.points, curve.interval, curve.q, t);
  return {{std::move(points.left), before, curve.q}, {std::move(points.right), after, curve.q}};
}

template <class Point>
std::vector<QBezierCurveOf<Point>> midpoint_pieces(const QBezierCurveOf<Point>& curve, int levels) {
  using Scalar = ScalarOf<Point>;
  if (levels < 0 || levels > kMaxQLevels)
    throw InvalidInput("midpoint_pieces: levels must be 0.." + std::to_string(kMaxQLevels) +
                       ", got " + std::to_string(levels));
  detail::check_basis("midpoint_pieces", curve.degree(), curve.interval, curve.q);
  std::vector<QBezierCurveOf<Point>> pieces{curve};
  for (int level = 0; level < levels; ++level) {
    std::vector<QBezierCurveOf<Point>> halves;
    for (const QBezierCurveOf<Point>& piece : pieces) {
      const Scalar middle = (piece.interval.from + piece.interval.to) / Scalar(2);
      QHalves<Point> both = subdivide(piece, middle);
      halves.push_back(std::move(both.left));
      halves.push_back(std::move(both.right));
    }
    pieces = std::move(halves);
  }
  return pieces;
}

using Rational = boost::multiprecision::cpp_rational;
using ExactPoint2 = Vec<Rational, 2>;
using ExactPoint3 = Vec<Rational, 3>;
using ExactPoint4 = Vec<Rational, 4>;

#define BLOSSOM_INSTANTIATE(Point)                                                               \
  template QCutPoints<Point> q_cut_points(const QBezierCurveOf<Point>&, const ScalarOf<Point>&); \
  template QHalves<Point> subdivide(const QBezierCurveOf<Point>&, const ScalarOf<Point>&);       \
  template std::vector<QBezierCurveOf<Point>> midpoint_pieces(const QBezierCurveOf<Point>&, int);
BLOSSOM_INSTANTIATE(Vec2)
BLOSSOM_INSTANTIATE(Vec3)
BLOSSOM_INSTANTIATE(Vec4)
BLOSSOM_INSTANTIATE(ExactPoint2)
BLOSSOM_INSTANTIATE(ExactPoint3)
BLOSSOM_INSTANTIATE(ExactPoint4)
#undef BLOSSOM_INSTANTIATE

template double q_cut_error(const QBezierCurveOf<Vec2>&, double);
template double q_cut_error(const QBezierCurveOf<Vec3>&, double);
template double q_cut_error(const QBezierCurveOf<Vec4>&, double);

}  // namespace blossom
