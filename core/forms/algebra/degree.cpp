// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/algebra/degree.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include "core/base/errors.h"
#include "core/forms/algebra/detail/degree_reduction.h"
#include "core/forms/algebra/detail/products.h"
#include "core/forms/detail/checks.h"
#include "core/math/matrix.h"

namespace blossom {
namespace {

void check_higher(const char* function, int from, int to) {
  detail::check_degree(function, from, kMaxProductDegree);
  detail::check_degree(function, to, kMaxProductDegree);
  if (to < from)
    throw InvalidInput(std::string(function) + ": the degree must be at least " +
                       std::to_string(from) + ", got " + std::to_string(to));
}

// The largest distance of `points` from `raised`, the elevated points of `lower`, with everything
// rounded up: each coordinate of `raised` may be off by `relative_error` of the largest of `lower`.
template <class Point>
double proven_distance(std::span<const Point> points, std::span<const Point> lower,
                       std::span<const Point> raised, double relative_error) {
  double distance = 0, size = 0;
  for (std::size_t k = 0; k < points.size(); ++k)
    distance = std::max(distance, norm(points[k] - raised[k]));
  for (const Point& point : lower) size = std::max(size, max_norm(point));
  // Differences, squares, their sum and its root round less than 16 times.
  constexpr double kRoundUp = 1 + 0x1p-49;
  return (distance + std::sqrt(Point::kDimension) * relative_error * size) * kRoundUp;
}

}  // namespace

template <class Point>
BezierCurveOf<Point> elevated(const BezierCurveOf<Point>& curve, int degree) {
  check_higher("elevated", curve.degree(), degree);
  if (degree == curve.degree()) return curve;
  return {detail::only_row(
      detail::elevated_net(detail::one_row(curve.points), 0, degree - curve.degree()))};
}

template <class Point>
BezierPatchOf<Point> elevated(const BezierPatchOf<Point>& patch, int degree_u, int degree_v) {
  check_higher("elevated", patch.degree_u(), degree_u);
  check_higher("elevated", patch.degree_v(), degree_v);
  BezierPatchOf<Point> result = patch;
  if (degree_u > patch.degree_u())
    result.points = detail::elevated_net(result.points, degree_u - patch.degree_u(), 0);
  if (degree_v > patch.degree_v())
    result.points = detail::elevated_net(result.points, 0, degree_v - patch.degree_v());
  return result;
}

template <class Point>
BezierTriangleOf<Point> elevated(const BezierTriangleOf<Point>& triangle, int degree) {
  check_higher("elevated", triangle.degree, degree);
  detail::check_triangle("elevated", triangle, kMaxProductDegree);
  BezierTriangleOf<Point> result = triangle;
  while (result.degree < degree) result = detail::elevated_once(result);
  return result;
}

template <class Point>
ReducedOf<BezierCurveOf<Point>> reduced(const BezierCurveOf<Point>& curve, int degree) {
  check_higher("reduced", degree, curve.degree());
  const Grid<double> matrix = detail::reduction_matrix(curve.degree(), degree);
  const BezierCurveOf<Point> lower{product(matrix, curve.points)};
  const BezierCurveOf<Point> raised = elevated(lower, curve.degree());
  return {lower, proven_distance<Point>(curve.points, lower.points, raised.points,
                                        elevation_error(curve.degree()))};
}

template <class Point>
ReducedOf<BezierPatchOf<Point>> reduced(const BezierPatchOf<Point>& patch, int degree_u,
                                        int degree_v) {
  check_higher("reduced", degree_u, patch.degree_u());
  check_higher("reduced", degree_v, patch.degree_v());
  const Grid<double> along_u = detail::reduction_matrix(patch.degree_u(), degree_u);
  const Grid<double> along_v = detail::reduction_matrix(patch.degree_v(), degree_v);
  const BezierPatchOf<Point> lower{product_transposed(product(along_u, patch.points), along_v)};
  const BezierPatchOf<Point> raised = elevated(lower, patch.degree_u(), patch.degree_v());
  const double rounding = elevation_error(patch.degree_u()) + elevation_error(patch.degree_v());
  return {lower, proven_distance<Point>(patch.points.values(), lower.points.values(),
                                        raised.points.values(), rounding)};
}

#define BLOSSOM_INSTANTIATE(Point)                                               \
  template BezierCurveOf<Point> elevated(const BezierCurveOf<Point>&, int);      \
  template BezierPatchOf<Point> elevated(const BezierPatchOf<Point>&, int, int); \
  template BezierTriangleOf<Point> elevated(const BezierTriangleOf<Point>&, int);
BLOSSOM_INSTANTIATE(double)
BLOSSOM_INSTANTIATE(Vec2)
BLOSSOM_INSTANTIATE(Vec3)
BLOSSOM_INSTANTIATE(Vec4)
#undef BLOSSOM_INSTANTIATE

TriangleReduction::TriangleReduction(int from, int to) : from_(from), to_(to) {
  check_higher("reduced", to, from);
  matrix_ = detail::triangle_reduction_matrix(from, to);
}

template <class Point>
ReducedOf<BezierTriangleOf<Point>> TriangleReduction::operator()(
    const BezierTriangleOf<Point>& triangle) const {
  detail::check_triangle("reduced", triangle, kMaxProductDegree);
  if (triangle.degree != from_) throw InvalidInput("reduced: the triangle has another degree");
  const BezierTriangleOf<Point> lower{to_, product(matrix_, triangle.points)};
  const BezierTriangleOf<Point> raised = elevated(lower, from_);
  return {lower, proven_distance<Point>(triangle.points, lower.points, raised.points,
                                        triangle_elevation_error(to_, from_))};
}

template <class Point>
ReducedOf<BezierTriangleOf<Point>> reduced(const BezierTriangleOf<Point>& triangle, int degree) {
  detail::check_triangle("reduced", triangle, kMaxProductDegree);
  return TriangleReduction(triangle.degree, degree)(triangle);
}

#define BLOSSOM_INSTANTIATE(Point)                                                          \
  template ReducedOf<BezierCurveOf<Point>> reduced(const BezierCurveOf<Point>&, int);       \
  template ReducedOf<BezierPatchOf<Point>> reduced(const BezierPatchOf<Point>&, int, int);  \
  template ReducedOf<BezierTriangleOf<Point>> reduced(const BezierTriangleOf<Point>&, int); \
  template ReducedOf<BezierTriangleOf<Point>> TriangleReduction::operator()(                \
      const BezierTriangleOf<Point>&) const;
BLOSSOM_INSTANTIATE(Vec2)
BLOSSOM_INSTANTIATE(Vec3)
BLOSSOM_INSTANTIATE(Vec4)
#undef BLOSSOM_INSTANTIATE

}  // namespace blossom
