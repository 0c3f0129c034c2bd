// SPDX-License-Identifier: LGPL-2.1-or-later
// Products of Bernstein forms.
//
// The product of forms of degrees n and n' has degree n + n', and each of its coefficients is a
// weighted mean of products of coefficients: so bounds by coefficients survive products.

#pragma once

#include "core/forms/function.h"
#include "core/math/roundoff.h"

namespace blossom {

/// f g.
///
///   h_k = sum_i binom(n, i) binom(n', k - i) / binom(n + n', k) f_i g_(k - i)
///
/// returns      degree n + n' in each direction
/// throws       InvalidInput if a form is empty or a degree of the result is above
///              kMaxProductDegree
/// accuracy     product_error, relative to the largest coefficients of f and of g
/// cost         O(n n'), O(n n' m m')
///
/// Source: Farouki and Rajan 1988.
BezierFunction product(const BezierFunction& f, const BezierFunction& g);
BezierFunction2 product(const BezierFunction2& f, const BezierFunction2& g);
template <class Point>
BezierCurveOf<Point> product(const BezierFunction& f, const BezierCurveOf<Point>& g);
template <class Point>
BezierPatchOf<Point> product(const BezierFunction2& f, const BezierPatchOf<Point>& g);

/// f x g.
///
/// accuracy     product_error plus 2^-53, times 2
BezierCurve cross_product(const BezierCurve& f, const BezierCurve& g);
BezierPatch cross_product(const BezierPatch& f, const BezierPatch& g);

/// f . g, of points of `Dim` coordinates.
///
/// accuracy     product_error plus Dim 2^-53, times Dim
template <class Point>
BezierFunction dot_product(const BezierCurveOf<Point>& f, const BezierCurveOf<Point>& g);
template <class Point>
BezierFunction2 dot_product(const BezierPatchOf<Point>& f, const BezierPatchOf<Point>& g);

/// Bound on the error of a coefficient, relative to the product of the factors' largest ones. The
/// arguments are the lower degree of the two factors in each direction, 0 in u for curves. A
/// sum has one term more than that; each term carries the binomials' products (4 and 4), its own
/// product, and the last division 5.
constexpr double product_error(int least_u, int least_v) {
  return ((least_u + 1) * (least_v + 1) + 13) * kUnitRoundoff;
}

}  // namespace blossom
