// SPDX-License-Identifier: LGPL-2.1-or-later
// The blossom (polar form) of a polynomial curve, in closed form.
//
// A polynomial curve C of degree n has exactly one blossom c(t1..tn): the function of n
// parameters that is symmetric, affine in each of them, and equal to C(t) when all of them are
// t. Its values at repeated interval ends are the Bezier points of C on that interval, so
// evaluation, conversion and subdivision are one formula.
//
// Notation: n degree, a_i monomial coefficients, sigma_i the i-th elementary symmetric
// polynomial, binom(n, i) the binomial coefficient. 0^0 is 1.
//
// Every function here is for points of two, three and four coordinates; four are homogeneous.

#pragma once

#include <span>

#include "core/forms/curve.h"
#include "core/math/interval.h"
#include "core/math/roundoff.h"

namespace blossom {

/// The blossom of a curve at n parameters.
///
///   c(t1..tn) = sum_{i=0..n} a_i sigma_i(s1..sn) / binom(n, i),   s = (t - centre) / scale
///
///   (1) symmetric:  any order of the parameters gives the same point
///   (2) affine:     c(.., (1-s)a + sb, ..) == (1-s) c(.., a, ..) + s c(.., b, ..)
///   (3) diagonal:   c(t..t) == C(t)
///
/// curve        n + 1 coefficients a_0..a_n, model units
/// parameters   n values, any reals
/// returns      a point, model units
/// throws       InvalidInput if the number of parameters is not n, one of them is not finite, or
///              n is not 0..kMaxDegree
/// accuracy     blossom_error(n) times sum |a_i| sigma_i(|s1|..|sn|) / binom(n, i)
/// cost         O(n^2)
///
/// Source: Ramshaw 1989; Vlachkova 2025, formula (2).
template <class Point>
Point blossom_at(const MonomialCurveOf<Point>& curve, std::span<const double> parameters);

/// The same of a Bezier curve: level r of de Casteljau's algorithm takes the parameter t_r.
///
/// accuracy     de_casteljau_error(n) for parameters in [0, 1], relative to the largest coordinate
///
/// Source: Ramshaw 1989.
template <class Point>
Point blossom_at(const BezierCurveOf<Point>& curve, std::span<const double> parameters);

/// The Bezier points of a curve on an interval: point k is the blossom at n - k copies of `from`
/// and k copies of `to`.
///
///   p_k = sum_i a_i / binom(n, i)
///         sum_j binom(k, j) binom(n - k, i - j) to^j from^(i - j)
///
/// curve        n + 1 coefficients, model units
/// interval     curve parameters; from > to gives the reversed curve, from == to gives n + 1
///              equal points
/// returns      n + 1 points, model units; the first is C(from), the last C(to)
/// throws       InvalidInput if an end of the interval is not finite, or n is not 0..kMaxDegree
/// accuracy     blossom_error(n) times blossom_scale(curve, interval)
/// cost         O(n^3)
///
/// Source: Vlachkova 2025, Theorem 1.
template <class Point>
BezierCurveOf<Point> bezier_points(const MonomialCurveOf<Point>& curve, const Interval& interval);

/// The same sums with all coefficients and parameters replaced by their absolute values: the
/// largest over all points and coordinates. Model units.
template <class Point>
double blossom_scale(const MonomialCurveOf<Point>& curve, const Interval& interval);

/// Bound on the error of the closed forms above, relative to the sum of the absolute values of
/// their terms. A power carries up to 3n roundings when the curve has a centre and a scale
/// (n without), the inner sum n / 2, the outer one n, and five single ones.
constexpr double blossom_error(int degree) { return (5 * degree + 6) * kUnitRoundoff; }

}  // namespace blossom
