// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blossom/composition.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/errors.h"
#include "core/blossom/detail/composition.h"
#include "core/forms/detail/checks.h"

namespace blossom {
namespace {

template <class Point, class Parameters>
void check(const BezierPatchOf<Point>& patch, const BezierCurveOf<Parameters>& curve) {
  detail::check_degree("composition", patch.degree_u());
  detail::check_degree("composition", patch.degree_v());
  if (curve.points.empty()) throw InvalidInput("composition: the parameter curve has no point");
  const int degree = curve.degree() * (patch.degree_u() + patch.degree_v());
  if (degree > kMaxProductDegree)
    throw InvalidInput("composition: the result has degree " + std::to_string(degree) +
                       ", the highest is " + std::to_string(kMaxProductDegree));
}

double growth(const detail::ParameterForms<double>& forms, int degree_u, int degree_v) {
  double largest_u = 0, largest_v = 0;
  for (std::size_t k = 0; k < forms.u0.size(); ++k) {
    largest_u = std::max(largest_u, std::abs(forms.u0[k]) + std::abs(forms.u1[k]));
    largest_v = std::max(largest_v, std::abs(forms.v0[k]) + std::abs(forms.v1[k]));
  }
  return std::pow(largest_u, degree_u) * std::pow(largest_v, degree_v);
}

}  // namespace

template <class Point>
BezierCurveOf<Point> composition(const BezierPatchOf<Point>& patch, const BezierCurve2& curve) {
  check(patch, curve);
  return {detail::composition(patch.points, detail::parameter_forms(curve.points))};
}

RationalBezierCurve composition(const RationalBezierPatch& patch, const BezierCurve& curve) {
  check(patch, curve);
  return {detail::composition(patch.points, detail::parameter_forms(curve.points))};
}

template <class Point>
BezierCurveOf<Point> on_segment(const BezierPatchOf<Point>& patch, const Vec2& from,
                                const Vec2& to) {
  return composition(patch, BezierCurve2{{from, to}});
}

double composition_growth(int degree_u, int degree_v, const BezierCurve2& curve) {
  return growth(detail::parameter_forms(curve.points), degree_u, degree_v);
}

double composition_growth(int degree_u, int degree_v, const BezierCurve& curve) {
  return growth(detail::parameter_forms(curve.points), degree_u, degree_v);
}

#define BLOSSOM_INSTANTIATE(Point)                                                             \
  template BezierCurveOf<Point> composition(const BezierPatchOf<Point>&, const BezierCurve2&); \
  template BezierCurveOf<Point> on_segment(const BezierPatchOf<Point>&, const Vec2&, const Vec2&);
BLOSSOM_INSTANTIATE(double)
BLOSSOM_INSTANTIATE(Vec2)
BLOSSOM_INSTANTIATE(Vec3)
BLOSSOM_INSTANTIATE(Vec4)
#undef BLOSSOM_INSTANTIATE

}  // namespace blossom
