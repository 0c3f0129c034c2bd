// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/subdivision/triangle_subdivision.h"

#include <cmath>
#include <string>

#include "core/base/errors.h"
#include "core/blossom/detail/checks.h"
#include "core/forms/detail/checks.h"
#include "core/subdivision/detail/triangle.h"

namespace blossom {
namespace {

void check(const TriangleCorners& corners) {
  for (std::size_t k = 0; k < corners.size(); ++k)
    if (!std::isfinite(corners[k][0]) || !std::isfinite(corners[k][1]))
      throw InvalidInput(std::string("sub_triangle: corner ") + "abc"[k] + " is not finite");
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
  detail::check_triangle("sub_triangle", triangle, kMaxDegree);
  check(corners);
  BezierTriangleOf<Point> result = triangle;
  BezierTriangleOf<Point> after_a = triangle;
  for (int nu = 0; nu <= triangle.degree; ++nu) {
    BezierTriangleOf<Point> after_b = after_a;
    for (int mu = 0; nu + mu <= triangle.degree; ++mu) {
      BezierTriangleOf<Point> value = after_b;
      while (value.degree > 0) value = detail::blossom_step(value, corners[2]);
      result(nu, mu) = value.points[0];
      if (after_b.degree > 0) after_b = detail::blossom_step(after_b, corners[1]);
    }
    if (after_a.degree > 0) after_a = detail::blossom_step(after_a, corners[0]);
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
