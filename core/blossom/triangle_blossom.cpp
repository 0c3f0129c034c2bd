// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blossom/triangle_blossom.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/errors.h"
#include "core/blossom/detail/checks.h"
#include "core/blossom/detail/closed_form.h"
#include "core/forms/detail/checks.h"

namespace blossom {
namespace {

template <class Point>
void check(const char* function, const MonomialPatchOf<Point>& patch, int degree, int highest) {
  detail::check_degree(function, patch.degree_u());
  detail::check_degree(function, patch.degree_v());
  detail::check_degree(function, degree, highest);
  detail::check_placement(function, patch.centre_u, patch.scale_u);
  detail::check_placement(function, patch.centre_v, patch.scale_v);
  for (int i = 0; i <= patch.degree_u(); ++i)
    for (int j = std::max(0, degree + 1 - i); j <= patch.degree_v(); ++j)
      if (patch.coefficients(i, j) != Point{})
        throw InvalidInput(std::string(function) + ": the degree " + std::to_string(degree) +
                           " is too low for the coefficient (" + std::to_string(i) + ", " +
                           std::to_string(j) + "), which is not 0");
}

void check(const char* function, std::span<const Vec2> arguments) {
  for (std::size_t k = 0; k < arguments.size(); ++k)
    if (!std::isfinite(arguments[k][0]) || !std::isfinite(arguments[k][1]))
      throw InvalidInput(std::string(function) + ": point " + std::to_string(k + 1) +
                         " of the parameter plane is not finite");
}

template <class Point>
Vec2 local(const MonomialPatchOf<Point>& patch, const Vec2& uv) {
  return {(uv[0] - patch.centre_u) / patch.scale_u, (uv[1] - patch.centre_v) / patch.scale_v};
}

template <class Point>
TriangleCorners local(const MonomialPatchOf<Point>& patch, const TriangleCorners& corners) {
  return {local(patch, corners[0]), local(patch, corners[1]), local(patch, corners[2])};
}

}  // namespace

template <class Point>
Point blossom_at(const MonomialPatchOf<Point>& patch, std::span<const Vec2> arguments) {
  check("blossom_at", patch, static_cast<int>(arguments.size()), 2 * kMaxDegree);
  check("blossom_at", arguments);
  std::vector<Vec2> points;
  for (const Vec2& argument : arguments) points.push_back(local(patch, argument));
  const Grid<double> weights =
      detail::triangle_blossoms(std::span<const Vec2>(points), patch.degree_u(), patch.degree_v());
  Point sum{};
  for (int i = 0; i <= patch.degree_u(); ++i) {
    Point row{};
    for (int j = 0; j <= patch.degree_v(); ++j) row += patch.coefficients(i, j) * weights(i, j);
    sum += row;
  }
  return sum;
}

template <class Point>
Point blossom_at(const BezierTriangleOf<Point>& triangle, std::span<const Vec2> arguments) {
  detail::check_triangle("blossom_at", triangle, 2 * kMaxDegree);
  check("blossom_at", arguments);
  if (static_cast<int>(arguments.size()) != triangle.degree)
    throw InvalidInput("blossom_at: a triangle of degree " + std::to_string(triangle.degree) +
                       " takes as many arguments, got " + std::to_string(arguments.size()));
  BezierTriangleOf<Point> value = triangle;
  for (const Vec2& argument : arguments) value = detail::blossom_step(value, argument);
  return value.points[0];
}

template <class Point>
BezierTriangleOf<Point> bezier_points(const MonomialPatchOf<Point>& patch,
                                      const TriangleCorners& corners, int degree) {
  check("bezier_points", patch, degree, kMaxDegree);
  check("bezier_points", corners);
  return {degree, detail::triangle_points(patch.coefficients, local(patch, corners), degree)};
}

template <class Point>
BezierTriangleOf<Point> bezier_points(const MonomialPatchOf<Point>& patch,
                                      const TriangleCorners& corners) {
  return bezier_points(patch, corners, patch.degree_u() + patch.degree_v());
}

template <class Point>
double triangle_scale(const MonomialPatchOf<Point>& patch, const TriangleCorners& corners,
                      int degree) {
  check("triangle_scale", patch, degree, kMaxDegree);
  check("triangle_scale", corners);
  Grid<Point> sizes = patch.coefficients;
  for (Point& point : sizes.values()) point = detail::absolute(point);
  TriangleCorners away = local(patch, corners);
  for (Vec2& corner : away) corner = detail::absolute(corner);
  double largest = 0;
  for (const Point& point : detail::triangle_points(sizes, away, degree))
    largest = std::max(largest, max_norm(point));
  return largest;
}

#define BLOSSOM_INSTANTIATE(Point)                                                  \
  template Point blossom_at(const MonomialPatchOf<Point>&, std::span<const Vec2>);  \
  template Point blossom_at(const BezierTriangleOf<Point>&, std::span<const Vec2>); \
  template BezierTriangleOf<Point> bezier_points(const MonomialPatchOf<Point>&,     \
                                                 const TriangleCorners&, int);      \
  template BezierTriangleOf<Point> bezier_points(const MonomialPatchOf<Point>&,     \
                                                 const TriangleCorners&);           \
  template double triangle_scale(const MonomialPatchOf<Point>&, const TriangleCorners&, int);
BLOSSOM_INSTANTIATE(Vec2)
BLOSSOM_INSTANTIATE(Vec3)
BLOSSOM_INSTANTIATE(Vec4)
#undef BLOSSOM_INSTANTIATE

}  // namespace blossom
