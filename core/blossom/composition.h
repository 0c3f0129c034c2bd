// SPDX-License-Identifier: LGPL-2.1-or-later
// A patch along a curve of its parameters, as a Bezier curve in space.
//
// S(u(t), v(t)) of a patch of degrees n, m and a parameter curve of degree d is a polynomial curve
// of degree d (n + m). In Bezier form its control points bound it, so a distance between a curve
// and its image on a surface is proven by comparing control points, without sampling.
//
// The patch may have any of the points of `core/forms/patch.h`, or be a scalar function; with four
// coordinates patch and result are homogeneous. The patch over a triangle of its parameters is the
// counterpart for areas: `core/subdivision/triangle_subdivision.h`.

#pragma once

#include "core/forms/function.h"
#include "core/math/roundoff.h"
#include "core/math/vec.h"

namespace blossom {

/// S(u(t), v(t)).
///
///   sum_ij P_ij B_i^n(u(t)) B_j^m(v(t)), with the powers of u, 1 - u, v, 1 - v as Bernstein forms
///
///   (1) the ends are S at the ends of the curve
///   (2) control points of the curve in the unit square: the result is in the hull of the net
///
/// patch        (n + 1) x (m + 1) points, model units
/// curve        d + 1 points (u, v), any reals
/// returns      d (n + m) + 1 points, model units
/// throws       InvalidInput if a degree of the patch is not 0..kMaxDegree, the curve has no point,
///              or the degree of the result is above kMaxProductDegree
/// accuracy     composition_error(n, m, d) times composition_growth, relative to the largest
///              coordinate of the net
/// cost         O(n m^2 d^2); a bicubic patch on a quintic: 1300 products a coordinate, 700 shared
///
/// Source: DeRose 1988; products as in Farouki and Rajan 1988.
template <class Point>
BezierCurveOf<Point> composition(const BezierPatchOf<Point>& patch, const BezierCurve2& curve);

/// The same for a rational parameter curve, points (wu, wv, w). The result is multiplied by
/// w(t)^(n + m), so the patch is homogeneous too.
RationalBezierCurve composition(const RationalBezierPatch& patch, const BezierCurve& curve);

/// S restricted to the segment between two points of the parameter plane: degree n + m.
///
/// accuracy, throws   those of composition with d = 1
template <class Point>
BezierCurveOf<Point> on_segment(const BezierPatchOf<Point>& patch, const Vec2& from,
                                const Vec2& to);

/// How much larger than the net the composition's terms can be: the largest
/// |1 - u_k| + |u_k| to the power n times that of v to the power m, k = 0..d. 1 for control points
/// in the unit square. A rational curve: |w - wu| + |wu|.
double composition_growth(int degree_u, int degree_v, const BezierCurve2& curve);
double composition_growth(int degree_u, int degree_v, const BezierCurve& curve);

/// Bound on the error of a coordinate of a composition, relative to the largest of the net and to
/// composition_growth. Each of n + m factors has 3 roundings (1 - u, its binomial), each of their
/// products d + 1; the sums over i and j n + m; the product of both directions min(n, m) d + 1;
/// weights of points, their products and the last division 6.
constexpr double composition_error(int degree_u, int degree_v, int degree) {
  const int least = degree_u < degree_v ? degree_u : degree_v;
  return ((degree_u + degree_v) * (degree + 5) + least * degree + 8) * kUnitRoundoff;
}

}  // namespace blossom
