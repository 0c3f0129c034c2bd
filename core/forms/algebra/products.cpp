// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/algebra/products.h"

#include "core/forms/algebra/detail/products.h"
#include "core/forms/detail/checks.h"

namespace blossom {
namespace {

template <class T, class U>
void check(const char* function, const BezierCurveOf<T>& f, const BezierCurveOf<U>& g) {
  detail::check_degree(function, f.degree(), kMaxProductDegree);
  detail::check_degree(function, g.degree(), kMaxProductDegree);
  detail::check_degree(function, f.degree() + g.degree(), kMaxProductDegree);
}

template <class T, class U>
void check(const char* function, const BezierPatchOf<T>& f, const BezierPatchOf<U>& g) {
  for (const int degree : {f.degree_u(), f.degree_v(), g.degree_u(), g.degree_v(),
                           f.degree_u() + g.degree_u(), f.degree_v() + g.degree_v()})
    detail::check_degree(function, degree, kMaxProductDegree);
}

}  // namespace

BezierFunction product(const BezierFunction& f, const BezierFunction& g) {
  return product<double>(f, g);
}

BezierFunction2 product(const BezierFunction2& f, const BezierFunction2& g) {
  return product<double>(f, g);
}

template <class Point>
BezierCurveOf<Point> product(const BezierFunction& f, const BezierCurveOf<Point>& g) {
  check("product", f, g);
  return {detail::only_row(
      detail::scalar_product(detail::one_row(f.points), detail::one_row(g.points)))};
}

template <class Point>
BezierPatchOf<Point> product(const BezierFunction2& f, const BezierPatchOf<Point>& g) {
  check("product", f, g);
  return {detail::scalar_product(f.points, g.points)};
}

BezierCurve cross_product(const BezierCurve& f, const BezierCurve& g) {
  check("cross_product", f, g);
  return {detail::only_row(
      detail::cross_product(detail::one_row(f.points), detail::one_row(g.points)))};
}

BezierPatch cross_product(const BezierPatch& f, const BezierPatch& g) {
  check("cross_product", f, g);
  return {detail::cross_product(f.points, g.points)};
}

template <class Point>
BezierFunction dot_product(const BezierCurveOf<Point>& f, const BezierCurveOf<Point>& g) {
  check("dot_product", f, g);
  return {
      detail::only_row(detail::dot_product(detail::one_row(f.points), detail::one_row(g.points)))};
}

template <class Point>
BezierFunction2 dot_product(const BezierPatchOf<Point>& f, const BezierPatchOf<Point>& g) {
  check("dot_product", f, g);
  return {detail::dot_product(f.points, g.points)};
}

#define BLOSSOM_INSTANTIATE(Point)                                                               \
  template BezierCurveOf<Point> product(const BezierFunction&, const BezierCurveOf<Point>&);     \
  template BezierPatchOf<Point> product(const BezierFunction2&, const BezierPatchOf<Point>&);    \
  template BezierFunction dot_product(const BezierCurveOf<Point>&, const BezierCurveOf<Point>&); \
  template BezierFunction2 dot_product(const BezierPatchOf<Point>&, const BezierPatchOf<Point>&);
BLOSSOM_INSTANTIATE(Vec2)
BLOSSOM_INSTANTIATE(Vec3)
BLOSSOM_INSTANTIATE(Vec4)
#undef BLOSSOM_INSTANTIATE

}  // namespace blossom
