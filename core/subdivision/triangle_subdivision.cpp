// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/subdivision/triangle_subdivision.h"

#include <cmath>
#include <string>

#include "core/base/errors.h"
#include "core/forms/detail/checks.h"
#include "core/subdivision/detail/triangle.h"

namespace blossom {
namespace {

void check(const TriangleCorners& corners) {
  for (std::size_t k = 0; k < corners.size(); ++k)
    if (!std::isfinite(corners[k][0]) || !std::isfinite(corners[k][1]))
      throw InvalidInput(std::string("sub_triangle: corner ") + "abc"[k] + " is not finite");
}

// The blossom with one argument given: a triangle of one degree less.
template <class Point>
BezierTriangleOf<Point> reduced(const BezierTriangleOf<Point>& triangle, const Vec2& corner) {
  const double x = corner[0], y = corner[1], z = 1 - x - y;
  BezierTriangleOf<Point> result;
  result.degree = triangle.degree - 1;
  for (int nu = 0; nu <= result.degree; ++nu)
    for (int mu = 0; nu + mu <= result.degree; ++mu)
      result.points.push_back(triangle(nu + 1, mu) * x + triangle(nu, mu + 1) * y +
                              triangle(nu, mu) * z);
  return result;
}

}  // namespace

template <class Point>
BezierTriangleOf<Point> sub_triangle(const BezierPatchOf<Point>& patch,
                                     const TriangleCorners& corners) {
  detail::check_degree("sub_triangle", patch.degree_u());
  detail::check_degree("sub_triangle", patch.degree_v());
  check(corners);
  return {patch.degree_u() + patch.degree_v(), detail::triangle_from_net(patch.points, corners)};
}

template <class Point>
BezierTriangleOf<Point> sub_triangle(const BezierTriangleOf<Point>& triangle,
                                     const TriangleCorners& corners) {
  detail::check_degree("sub_triangle", triangle.degree);
  check(corners);
  const std::size_t wanted = BezierTriangleOf<Point>::count(triangle.degree);
  if (triangle.points.size() != wanted)
    throw InvalidInput("sub_triangle: a triangle of degree " + std::to_string(triangle.degree) +
                       " has " + std::to_string(wanted) + " points, got " +
                       std::to_string(triangle.points.size()));
  BezierTriangleOf<Point> result = triangle;
  BezierTriangleOf<Point> after_a = triangle;
  for (int nu = 0; nu <= triangle.degree; ++nu) {
    BezierTriangleOf<Point> after_b = after_a;
    for (int mu = 0; nu + mu <= triangle.degree; ++mu) {
      BezierTriangleOf<Point> value = after_b;
      while (value.degree > 0) value = reduced(value, corners[2]);
      result(nu, mu) = value.points[0];
      if (after_b.degree > 0) after_b = reduced(after_b, corners[1]);
    }
    if (after_a.degree > 0) after_a = reduced(after_a, corners[0]);
  }
  return result;
}

#define BLOSSOM_INSTANTIATE(Point)                                              \
  template BezierTriangleOf<Point> sub_triangle(const BezierPatchOf<Point>&,    \
                                                const TriangleCorners&);        \
  template BezierTriangleOf<Point> sub_triangle(const BezierTriangleOf<Point>&, \
                                                const TriangleCorners&);
BLOSSOM_INSTANTIATE(Vec2)
BLOSSOM_INSTANTIATE(Vec3)
BLOSSOM_INSTANTIATE(Vec4)
#undef BLOSSOM_INSTANTIATE

}  // namespace blossom
