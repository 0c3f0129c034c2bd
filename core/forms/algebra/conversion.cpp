// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/algebra/conversion.h"

#include "core/forms/algebra/detail/conversion.h"
#include "core/forms/detail/checks.h"

namespace blossom {
namespace {

double centre(Origin origin) { return origin == Origin::Start ? 0 : 0.5; }
double scale(Origin origin) { return origin == Origin::Start ? 1 : 0.5; }

}  // namespace

template <class Point>
MonomialCurveOf<Point> monomial_form(const BezierCurveOf<Point>& curve, Origin origin) {
  detail::check_degree("monomial_form", curve.degree());
  return {detail::monomial_line(curve.points, origin), centre(origin), scale(origin)};
}

template <class Point>
MonomialPatchOf<Point> monomial_form(const BezierPatchOf<Point>& patch, Origin origin) {
  detail::check_degree("monomial_form", patch.degree_u());
  detail::check_degree("monomial_form", patch.degree_v());
  return {detail::monomial_net(patch.points, origin), centre(origin), centre(origin), scale(origin),
          scale(origin)};
}

template <class Point>
MonomialPatchOf<Point> monomial_form(const BezierTriangleOf<Point>& triangle) {
  detail::check_triangle("monomial_form", triangle, kMaxDegree);
  return {detail::monomial_triangle(triangle), 0, 0, 1, 1};
}

template <class Point>
BezierCurveOf<Point> bezier_form(const MonomialCurveOf<Point>& curve) {
  detail::check_degree("bezier_form", curve.degree());
  detail::check_placement("bezier_form", curve.centre, curve.scale);
  return {detail::bezier_line(curve, {0, 1})};
}

template <class Point>
BezierPatchOf<Point> bezier_form(const MonomialPatchOf<Point>& patch) {
  detail::check_degree("bezier_form", patch.degree_u());
  detail::check_degree("bezier_form", patch.degree_v());
  detail::check_placement("bezier_form", patch.centre_u, patch.scale_u);
  detail::check_placement("bezier_form", patch.centre_v, patch.scale_v);
  return {detail::bezier_net(patch, {0, 1}, {0, 1})};
}

#define BLOSSOM_INSTANTIATE(Point)                                                    \
  template MonomialCurveOf<Point> monomial_form(const BezierCurveOf<Point>&, Origin); \
  template MonomialPatchOf<Point> monomial_form(const BezierPatchOf<Point>&, Origin); \
  template MonomialPatchOf<Point> monomial_form(const BezierTriangleOf<Point>&);      \
  template BezierCurveOf<Point> bezier_form(const MonomialCurveOf<Point>&);           \
  template BezierPatchOf<Point> bezier_form(const MonomialPatchOf<Point>&);
BLOSSOM_INSTANTIATE(Vec2)
BLOSSOM_INSTANTIATE(Vec3)
BLOSSOM_INSTANTIATE(Vec4)
#undef BLOSSOM_INSTANTIATE

RationalBezierPatch homogeneous(const BezierPatch& patch) {
  RationalBezierPatch result{Grid<Vec4>(patch.points.rows(), patch.points.columns())};
  for (std::size_t k = 0; k < patch.points.values().size(); ++k) {
    const Vec3& p = patch.points.values()[k];
    result.points.values()[k] = {p[0], p[1], p[2], 1};
  }
  return result;
}

}  // namespace blossom
