// SPDX-License-Identifier: LGPL-2.1-or-later
// Tensor-product (q1,q2)-Bezier surfaces.
//
// Everything works direction by direction: the blossom is that of the curves along u and of those
// along v, each with its own parameters, and their order does not matter.
//
// Every function here is for points of two, three and four coordinates, of double or of
// boost::multiprecision::cpp_rational. Each throws InvalidInput with the reason if a basis does not
// exist or a value is not finite.

#pragma once

#include <span>

#include "core/forms/patch.h"
#include "core/math/grid.h"
#include "core/papers/q_curve.h"

namespace blossom {

/// S(u, v) = sum_kl points(k, l) B_k^n(u; [a,b]; q1,q2) B_l^m(v; [c,d]; r1,r2); (n + 1) x (m + 1)
/// points, model units.
template <class Point>
struct QBezierPatchOf {
  Grid<Point> points;
  IntervalOf<ScalarOf<Point>> u;     ///< [a, b]
  IntervalOf<ScalarOf<Point>> v;     ///< [c, d]
  QParametersOf<ScalarOf<Point>> q;  ///< along u
  QParametersOf<ScalarOf<Point>> r;  ///< along v

  int degree_u() const { return points.rows() - 1; }
  int degree_v() const { return points.columns() - 1; }
  friend bool operator==(const QBezierPatchOf&, const QBezierPatchOf&) = default;
};

using QBezierPatch = QBezierPatchOf<Vec3>;

/// The blossom of a monomial patch at n pairs along u and m along v.
///
///   (1) symmetric and linear in the pairs of u and, separately, in those of v
///   (2) diagonal in both: S(u, v)
///
/// throws       also if a number of arguments is wrong
/// cost         O(n m + n^2 + m^2)
///
/// Source: Disibuyuk 2022, Theorem 2.2, in each direction.
template <class Point>
Point q_blossom_at(const MonomialPatchOf<Point>& patch, const QParametersOf<ScalarOf<Point>>& q,
                   const QParametersOf<ScalarOf<Point>>& r, std::span<const PairOf<Point>> along_u,
                   std::span<const PairOf<Point>> along_v);

/// S(u, v) by the evaluation algorithms of two permutations, of 1..n and of 1..m.
///
/// accuracy     q_evaluation_error
/// cost         O(n m (n + m))
///
/// Source: Disibuyuk 2022, Theorem 3.3, in each direction.
template <class Point>
Point point_at(const QBezierPatchOf<Point>& patch, const ScalarOf<Point>& u,
               const ScalarOf<Point>& v, std::span<const int> permutation_u,
               std::span<const int> permutation_v);

/// The same with identity permutations.
template <class Point>
Point point_at(const QBezierPatchOf<Point>& patch, const ScalarOf<Point>& u,
               const ScalarOf<Point>& v);

/// Bound on the error of a coordinate of point_at with these permutations, model units.
template <class Point>
double q_evaluation_error(const QBezierPatchOf<Point>& patch, double u, double v,
                          std::span<const int> permutation_u, std::span<const int> permutation_v);

/// The control points of a patch over u x v: the dual functionals of both directions.
///
/// Source: Disibuyuk 2022, Corollary 3.7, in each direction.
template <class Point>
QBezierPatchOf<Point> q_bezier_form(const MonomialPatchOf<Point>& patch,
                                    const IntervalOf<ScalarOf<Point>>& u,
                                    const IntervalOf<ScalarOf<Point>>& v,
                                    const QParametersOf<ScalarOf<Point>>& q,
                                    const QParametersOf<ScalarOf<Point>>& r);

/// The same from a classical patch whose unit square is laid on u x v.
template <class Point>
QBezierPatchOf<Point> q_bezier_form(const BezierPatchOf<Point>& patch,
                                    const IntervalOf<ScalarOf<Point>>& u,
                                    const IntervalOf<ScalarOf<Point>>& v,
                                    const QParametersOf<ScalarOf<Point>>& q,
                                    const QParametersOf<ScalarOf<Point>>& r);

/// The plain power basis, centres 0 and scales 1. For double no bound is stated.
template <class Point>
MonomialPatchOf<Point> monomial_form(const QBezierPatchOf<Point>& patch);

/// The classical net W = Q_u b Q_v^T, the unit square laid on u x v.
///
/// accuracy     bezier_form_error(patch)
/// cost         O(n^3 + m^3 + n m (n + m))
template <class Point>
BezierPatchOf<Point> bezier_form(const QBezierPatchOf<Point>& patch);

/// Bound on the error of a coordinate of bezier_form, model units:
/// (q_conversion_error(n) + q_conversion_error(m)) max sum_kl Q~_u(i, k) Q~_v(j, l) |b_kl|.
template <class Point>
double bezier_form_error(const QBezierPatchOf<Point>& patch);

/// The four quadrants at a cut: (0, 0) over [a, s] x [c, t], (1, 0) over [s, b] x [c, t], and so
/// on.
///
/// returns      2 x 2 patches with the same parameters
/// throws       InvalidInput also if a basis over a half does not exist, as for curves
///
/// Source: Disibuyuk 2022, Theorem 5.1, in each direction.
template <class Point>
Grid<QBezierPatchOf<Point>> subdivide(const QBezierPatchOf<Point>& patch, const ScalarOf<Point>& s,
                                      const ScalarOf<Point>& t);

}  // namespace blossom
