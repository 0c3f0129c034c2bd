// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blossom/triangle_conversion.h"

#include <algorithm>
#include <cmath>

#include "core/blossom/detail/triangle_conversion.h"
#include "core/forms/algebra/degree.h"
#include "core/forms/detail/checks.h"
#include "core/math/roundoff.h"

namespace blossom {
namespace {

constexpr Vec2 kA{1, 0}, kB{0, 1}, kC{0, 0};
constexpr Vec2 kMiddleAB{0.5, 0.5}, kMiddleBC{0, 0.5}, kMiddleCA{0.5, 0};
constexpr Vec2 kMiddle{1.0 / 3, 1.0 / 3};

// The curve nearest to a row of a patch with the given degree, and its distance.
template <class Point>
ReducedOf<BezierCurveOf<Point>> with_degree(const BezierCurveOf<Point>& row, int degree) {
  if (degree <= row.degree()) return reduced(row, degree);
  double largest = 0;
  for (const Point& point : row.points) largest = std::max(largest, max_norm(point));
  return {elevated(row, degree), std::sqrt(Point::kDimension) * elevation_error(degree) * largest};
}

}  // namespace

template <class Point>
BezierPatchOf<Point> collapsed_patch(const BezierTriangleOf<Point>& triangle) {
  detail::check_triangle("collapsed_patch", triangle, kMaxDegree);
  BezierPatchOf<Point> patch{detail::collapsed_net(triangle)};
  // The vertex as it is, without a rounding.
  for (int j = 0; j <= triangle.degree; ++j) patch.points(0, j) = triangle(0, 0);
  return patch;
}

template <class Point>
TriangleOfPatch<Point> triangle_of(const BezierPatchOf<Point>& patch) {
  detail::check_degree("triangle_of", patch.degree_u());
  detail::check_degree("triangle_of", patch.degree_v());
  const int n = patch.degree_u();
  TriangleOfPatch<Point> result;
  result.triangle.degree = n;
  result.triangle.points.resize(BezierTriangleOf<Point>::count(n));
  for (int i = 0; i <= n; ++i) {
    BezierCurveOf<Point> row;
    for (int j = 0; j <= patch.degree_v(); ++j) row.points.push_back(patch.points(i, j));
    const auto [layer, error] = with_degree(row, i);
    for (int mu = 0; mu <= i; ++mu)
      result.triangle(i - mu, mu) = layer.points[static_cast<std::size_t>(mu)];
    result.error = std::max(result.error, error);
  }
  return result;
}

template <class Point>
std::array<BezierPatchOf<Point>, 3> three_quads(const BezierTriangleOf<Point>& triangle) {
  detail::check_triangle("three_quads", triangle, kMaxDegree);
  return {BezierPatchOf<Point>{detail::quad_net(triangle, {kA, kMiddleCA, kMiddleAB, kMiddle})},
          BezierPatchOf<Point>{detail::quad_net(triangle, {kB, kMiddleAB, kMiddleBC, kMiddle})},
          BezierPatchOf<Point>{detail::quad_net(triangle, {kC, kMiddleBC, kMiddleCA, kMiddle})}};
}

template <class Point>
BezierPatchOf<Point> half_patch(const BezierTriangleOf<Point>& triangle) {
  detail::check_triangle("half_patch", triangle, kMaxDegree);
  const int n = triangle.degree;
  BezierPatchOf<Point> patch{detail::half_net(triangle)};
  for (int i = 0; i <= n; ++i) {  // without a rounding
    patch.points(i, 0) = triangle(i, 0);
    patch.points(0, i) = triangle(0, i);
  }
  return patch;
}

double half_patch_error(int degree) {
  return (5 * degree + 6 + degree) * std::pow(1.5, degree) * kUnitRoundoff;
}

#define BLOSSOM_INSTANTIATE(Point)                                               \
  template BezierPatchOf<Point> collapsed_patch(const BezierTriangleOf<Point>&); \
  template TriangleOfPatch<Point> triangle_of(const BezierPatchOf<Point>&);      \
  template BezierPatchOf<Point> half_patch(const BezierTriangleOf<Point>&);      \
  template std::array<BezierPatchOf<Point>, 3> three_quads(const BezierTriangleOf<Point>&);
BLOSSOM_INSTANTIATE(Vec2)
BLOSSOM_INSTANTIATE(Vec3)
BLOSSOM_INSTANTIATE(Vec4)
#undef BLOSSOM_INSTANTIATE

}  // namespace blossom
