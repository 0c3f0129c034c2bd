// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/algebra/derivatives.h"

#include <string>

#include "core/base/errors.h"
#include "core/forms/algebra/detail/derivatives.h"
#include "core/forms/detail/checks.h"

namespace blossom {
namespace {

void check_order(const char* function, int order) {
  if (order < 0)
    throw InvalidInput(std::string(function) + ": the order must not be negative, got " +
                       std::to_string(order));
}

}  // namespace

template <class Point>
BezierCurveOf<Point> derivative(const BezierCurveOf<Point>& curve, int order) {
  detail::check_degree("derivative", curve.degree(), kMaxProductDegree);
  check_order("derivative", order);
  return {detail::only_row(detail::derivative_net(detail::one_row(curve.points), 0, order))};
}

template <class Point>
BezierPatchOf<Point> derivative(const BezierPatchOf<Point>& patch, int order_u, int order_v) {
  detail::check_degree("derivative", patch.degree_u(), kMaxProductDegree);
  detail::check_degree("derivative", patch.degree_v(), kMaxProductDegree);
  check_order("derivative", order_u);
  check_order("derivative", order_v);
  return {detail::derivative_net(patch.points, order_u, order_v)};
}

template <class Point>
BezierTriangleOf<Point> derivative(const BezierTriangleOf<Point>& triangle, int order_x,
                                   int order_y) {
  detail::check_triangle("derivative", triangle, kMaxProductDegree);
  check_order("derivative", order_x);
  check_order("derivative", order_y);
  BezierTriangleOf<Point> result = triangle;
  for (int k = 0; k < order_x; ++k) result = detail::one_derivative(result, detail::By::U);
  for (int k = 0; k < order_y; ++k) result = detail::one_derivative(result, detail::By::V);
  return result;
}

RationalBezierCurve rational_derivative(const RationalBezierCurve& curve, int order) {
  check_order("rational_derivative", order);
  detail::check_degree("rational_derivative", curve.degree(), kMaxProductDegree / (order + 1));
  return {detail::only_row(detail::rational_derivative(detail::one_row(curve.points), 0, order))};
}

RationalBezierPatch rational_derivative(const RationalBezierPatch& patch, int order_u,
                                        int order_v) {
  check_order("rational_derivative", order_u);
  check_order("rational_derivative", order_v);
  const int highest = kMaxProductDegree / (order_u + order_v + 1);
  detail::check_degree("rational_derivative", patch.degree_u(), highest);
  detail::check_degree("rational_derivative", patch.degree_v(), highest);
  return {detail::rational_derivative(patch.points, order_u, order_v)};
}

RationalBezierTriangle rational_derivative(const RationalBezierTriangle& triangle, int order_x,
                                           int order_y) {
  check_order("rational_derivative", order_x);
  check_order("rational_derivative", order_y);
  detail::check_triangle("rational_derivative", triangle,
                         kMaxProductDegree / (order_x + order_y + 1));
  return detail::rational_derivative(triangle, order_x, order_y);
}

#define BLOSSOM_INSTANTIATE(Point)                                                 \
  template BezierCurveOf<Point> derivative(const BezierCurveOf<Point>&, int);      \
  template BezierPatchOf<Point> derivative(const BezierPatchOf<Point>&, int, int); \
  template BezierTriangleOf<Point> derivative(const BezierTriangleOf<Point>&, int, int);
BLOSSOM_INSTANTIATE(double)
BLOSSOM_INSTANTIATE(Vec2)
BLOSSOM_INSTANTIATE(Vec3)
BLOSSOM_INSTANTIATE(Vec4)
#undef BLOSSOM_INSTANTIATE

}  // namespace blossom
