// SPDX-License-Identifier: LGPL-2.1-or-later
// Derivatives of any order as Bezier forms: hodographs.
//
// A derivative's control points bound it as those of a curve bound the curve. An order above the
// degree gives the constant 0.

#pragma once

#include "core/forms/function.h"
#include "core/forms/triangle.h"
#include "core/math/roundoff.h"

namespace blossom {

/// The derivative of the given order by the parameter.
///
///   C^(r) = n! / (n - r)! sum_i Delta^r p_i B_i^(n - r)
///
/// returns      degree max(n - r, 0); model units
/// throws       InvalidInput if an order is negative, there is no point or the degree is above
///              kMaxProductDegree
/// accuracy     derivative_error(n, r), relative to the largest coordinate
///
/// Source: Farin 2002.
template <class Point>
BezierCurveOf<Point> derivative(const BezierCurveOf<Point>& curve, int order);

/// The mixed partial derivative.
///
/// accuracy     the sum of both relative errors times the product of both growths, see below
template <class Point>
BezierPatchOf<Point> derivative(const BezierPatchOf<Point>& patch, int order_u, int order_v);

/// The mixed partial derivative by the barycentric x (towards a) and y (towards b).
///
///   returns   degree max(N - order_x - order_y, 0)
///   throws    as above, and InvalidInput if the number of points does not fit the degree
///   accuracy  derivative_error(N, order_x + order_y)
template <class Point>
BezierTriangleOf<Point> derivative(const BezierTriangleOf<Point>& triangle, int order_x,
                                   int order_y);

/// The derivative of the point X / w, as a homogeneous form over w^(r + 1), exact as a form:
///
///   N_0 = X,   N_k = w N_(k-1)' - k w' N_(k-1),   C^(r) = N_r / w^(r + 1)
///
/// returns      degree (r + 1) n in each direction, r the total order
/// throws       InvalidInput as above, or if the degree of the result is above kMaxProductDegree
/// accuracy     rational_derivative_error, relative to largest coordinate or weight to the power
///              r + 1
RationalBezierCurve rational_derivative(const RationalBezierCurve& curve, int order);
RationalBezierPatch rational_derivative(const RationalBezierPatch& patch, int order_u, int order_v);

/// The same by the barycentric x and y.
///
/// throws       also if the number of points does not fit the degree
/// accuracy     rational_triangle_derivative_error, likewise
RationalBezierTriangle rational_derivative(const RationalBezierTriangle& triangle, int order_x,
                                           int order_y);

/// The largest value of a derivative's points for points of size 1: 2^r n! / (n - r)!.
constexpr double derivative_growth(int degree, int order) {
  double growth = 1;
  for (int k = 0; k < order; ++k) growth *= 2.0 * (degree > k ? degree - k : 0);
  return growth;
}

/// Bound on the error of a coordinate, relative to the largest: a difference and a product for each
/// order.
constexpr double derivative_error(int degree, int order) {
  return 2 * order * derivative_growth(degree, order) * kUnitRoundoff;
}
constexpr double derivative_error(int degree_u, int degree_v, int order_u, int order_v) {
  return 2 * (order_u + order_v) * derivative_growth(degree_u, order_u) *
         derivative_growth(degree_v, order_v) * kUnitRoundoff;
}

/// Bound on the error of a coordinate of a rational derivative, relative to the (r + 1)-th power of
/// the largest coordinate or weight. Step k makes the size at most 2d + 2kn times as large, where
/// d, the degree of N_(k-1), is at most k n. It has two derivatives (2 roundings) beside a product
/// with sums of up to (n + 1)(m + 1) terms, the factor k and a difference; the last elevation is a
/// product too.
constexpr double rational_derivative_error(int degree_u, int degree_v, int order) {
  const int degree = degree_u > degree_v ? degree_u : degree_v;
  const int terms = (degree_u + 1) * (degree_v + 1);
  double size = 1;
  for (int k = 1; k <= order; ++k) size *= degree > 0 ? 4.0 * k * degree : 1;
  return (order * (terms + 17) + (order + 1) * (order + 1) + 13) * size * kUnitRoundoff;
}

/// Likewise of a triangle, by the total order: products of up to (n + 1)(n + 2) / 2 terms, and an
/// elevation of 5 roundings for each step.
constexpr double rational_triangle_derivative_error(int degree, int order) {
  const int terms = (degree + 1) * (degree + 2) / 2;
  double size = 1;
  for (int k = 1; k <= order; ++k) size *= degree > 0 ? 4.0 * k * degree : 1;
  return order * (terms + 22) * size * kUnitRoundoff;
}

}  // namespace blossom
