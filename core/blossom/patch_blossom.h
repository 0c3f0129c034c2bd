// SPDX-License-Identifier: LGPL-2.1-or-later
// The blossom of a tensor-product patch, in closed form.
//
// It is symmetric and affine in the n parameters of u and, separately, in the m parameters of v.
// Notation as in `core/blossom/curve_blossom.h`; a_ij is the coefficient of u^i v^j.

#pragma once

#include <span>

#include "core/blossom/curve_blossom.h"
#include "core/forms/patch.h"
#include "core/math/interval.h"

namespace blossom {

/// The blossom of a patch at n parameters of u and m of v.
///
///   s(u1..un; v1..vm) = sum_ij a_ij sigma_i(u1..un) / binom(n, i) sigma_j(v1..vm) / binom(m, j)
///
/// u, v         n and m values, any reals
/// returns      a point, model units
/// throws       InvalidInput if a number of parameters is wrong, one of them is not finite, or a
///              degree is not 0..kMaxDegree
/// accuracy     blossom_error(n + m) times the sum of the terms' absolute values; a Bezier patch
///              de_casteljau_error(n + m) in the unit square
/// cost         O(n m)
///
/// Source: Vlachkova 2025, formulas (7) and (8).
template <class Point>
Point blossom_at(const MonomialPatchOf<Point>& patch, std::span<const double> u,
                 std::span<const double> v);
template <class Point>
Point blossom_at(const BezierPatchOf<Point>& patch, std::span<const double> u,
                 std::span<const double> v);

/// The Bezier net of a patch on a rectangle: point (nu, mu) is the blossom at n - nu copies of
/// u.from, nu of u.to, m - mu of v.from and mu of v.to.
///
///   p_{nu mu} = sum_ij a_ij M_u(nu, i) M_v(mu, j)
///
/// with M as in Theorem 1 for u and for v: the printed sum (9), factorised.
///
/// u, v         patch parameters; reversed and degenerate intervals as for curves
/// returns      (n + 1) x (m + 1) points, model units; corners first and last
/// throws       InvalidInput if an end is not finite, or a degree is not 0..kMaxDegree
/// accuracy     blossom_error(n + m) times blossom_scale(patch, u, v)
/// cost         O(n^3 + m^3 + n m (n + m))
///
/// Source: Vlachkova 2025, Theorem 2.
template <class Point>
BezierPatchOf<Point> bezier_points(const MonomialPatchOf<Point>& patch, const Interval& u,
                                   const Interval& v);

/// The same sums with absolute values throughout, the largest of all. Model units.
template <class Point>
double blossom_scale(const MonomialPatchOf<Point>& patch, const Interval& u, const Interval& v);

}  // namespace blossom
