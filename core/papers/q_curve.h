// SPDX-License-Identifier: LGPL-2.1-or-later
// (q1,q2)-Bezier curves: values, the way to and from other forms, subdivision.
//
// Every polynomial curve is a (q1,q2)-Bezier curve over every admissible interval, so these curves
// are polynomial curves with other control points. For modelling, convert once with `bezier_form`:
// classical points converge faster under subdivision, need no admissible sub-intervals, and go to
// Open CASCADE.
//
// Every function here is for points of two, three and four coordinates, of double or of
// boost::multiprecision::cpp_rational. Notation as in `core/papers/q_bernstein.h`.

#pragma once

#include <vector>

#include "core/forms/curve.h"
#include "core/math/grid.h"
#include "core/math/interval.h"
#include "core/math/roundoff.h"
#include "core/papers/q_blossom.h"
#include "core/papers/q_numbers.h"

namespace blossom {

/// P(x) = sum_k points[k] B_k^n(x; [a,b]; q1,q2); n + 1 points, model units.
///
///   (1) P(a) is the first point, P(b) the last
///   (2) affine maps of the points are affine maps of the curve
///   (3) inside the convex hull of the points for safe parameters (q_basis_obstacle)
///   (4) q1 / q2 decides; x -> w x of x, a and b changes nothing, a translation of them does
template <class Point>
struct QBezierCurveOf {
  std::vector<Point> points;
  IntervalOf<ScalarOf<Point>> interval;
  QParametersOf<ScalarOf<Point>> q;

  int degree() const { return static_cast<int>(points.size()) - 1; }
  friend bool operator==(const QBezierCurveOf&, const QBezierCurveOf&) = default;
};

using QBezierCurve = QBezierCurveOf<Vec3>;

/// P(x), by the evaluation algorithm of the identity permutation.
///
/// x            any real
/// throws       InvalidInput if the basis does not exist, with the reason, or a number is not
///              finite; so do all functions below
/// accuracy     q_evaluation_error
/// cost         O(n^2)
///
/// Source: Disibuyuk 2022, Theorem 3.3.
template <class Point>
Point point_at(const QBezierCurveOf<Point>& curve, const ScalarOf<Point>& x);

/// The curve's control points over an interval: the dual functionals, q_control_points for c = 1.
///
/// accuracy     q_blossom_error(n) times q_blossom_scale
///
/// Source: Disibuyuk 2022, Corollaries 3.2 and 3.7.
template <class Point>
QBezierCurveOf<Point> q_bezier_form(const MonomialCurveOf<Point>& curve,
                                    const IntervalOf<ScalarOf<Point>>& interval,
                                    const QParametersOf<ScalarOf<Point>>& q);

/// The (q1,q2)-Bezier form of a classical Bezier curve whose [0, 1] is laid on the interval: solves
/// Q b = w with Q = q_conversion_matrix.
///
/// accuracy     exact for rationals; for double, backward stable elimination with partial pivoting,
///              without a stated bound
/// cost         O(n^3)
template <class Point>
QBezierCurveOf<Point> q_bezier_form(const BezierCurveOf<Point>& curve,
                                    const IntervalOf<ScalarOf<Point>>& interval,
                                    const QParametersOf<ScalarOf<Point>>& q);

/// The plain power basis, centre 0 and scale 1:
///
///   c_k = q1^(k(k-1)/2) q2^((n-k)(n-k-1)/2) [n,k] p((1,0) k times, (0,1) n - k times)
///
/// returns      n + 1 coefficients, model units
/// accuracy     exact for rationals; for double no bound is stated, prefer bezier_form
/// cost         O(n^3)
///
/// Source: Disibuyuk 2022, Theorems 2.2 and 2.5.
template <class Point>
MonomialCurveOf<Point> monomial_form(const QBezierCurveOf<Point>& curve);

/// The classical Bezier points w = Q b of the same curve, [0, 1] laid on [a, b].
///
/// accuracy     bezier_form_error(curve)
/// cost         O(n^3)
template <class Point>
BezierCurveOf<Point> bezier_form(const QBezierCurveOf<Point>& curve);

/// Q(j, k) is the j-th classical Bernstein coefficient over [a, b] of B_k^n(.; [a,b]; q1,q2). It
/// comes from the linear factors, which are multiplied in Bernstein form. With
/// D_i = q1^i a - q2^i b,
///
///   q1^i a - q2^i x  goes from (q1^i - q2^i) a to D_i,
///   q1^i x - q2^i b  goes from D_i to (q1^i - q2^i) b
///
///   (1) rows sum to 1, the first and the last row are unit rows
///   (2) no entry is negative for safe parameters (q_basis_obstacle)
///
/// returns      (n + 1) x (n + 1), dimensionless
/// cost         O(n^3)
///
/// Source: Disibuyuk 2022, (3.4), as products of Bernstein polynomials.
template <class Scalar>
Grid<Scalar> q_conversion_matrix(int n, const IntervalOf<Scalar>& interval,
                                 const QParametersOf<Scalar>& q);

/// Bound on the error of a coordinate of bezier_form: q_conversion_error(n) times the largest
/// sum_k Q~(j, k) |b_k|, where Q~ is Q with sizes for differences. Q~ = Q for q1, q2 > 0 that are
/// safe. Model units.
template <class Point>
double bezier_form_error(const QBezierCurveOf<Point>& curve);

/// Roundings of bezier_form to first order: a factor 2 i + 4 and its divisor 2 i + 4 and 1, i < n,
/// the product 2 n, [n,k] at most n^2 / 4 + 2 n, two for the scaling, and n + 1 for the sum.
constexpr double q_conversion_error(int degree) {
  return (2.25 * degree * degree + 12 * degree + 3) * kUnitRoundoff;
}

/// The points at a cut t: the values of the blossom that are control points over [a, t] and [t, b]
/// wherever the basis exists there. They exist in any case, and may be all that does.
///
///   left_i  = p((q1^(n-1) a, q2^(n-1)), .., (q1^i a, q2^i), (q1^(i-1) t, q2^(i-1)), .., (t, 1))
///           = sum_j b_j B_j^i(t; [a,b]; q1,q2)
///   right_i = p((q1^(n-1) t, q2^(n-1)), .., (q1^i t, q2^i), (q1^(i-1) b, q2^(i-1)), .., (b, 1))
///           = sum_j b_(i+j) B_j^(n-i)(t; [a,b]; q1,q2)
template <class Point>
struct QCutPoints {
  std::vector<Point> left;   ///< n + 1 points; the intermediate points of the identity
  std::vector<Point> right;  ///< n + 1 points; those of the reversed permutation
};

/// accuracy     q_cut_error
/// cost         O(n^2)
///
/// Source: Disibuyuk 2022, Theorem 5.1.
template <class Point>
QCutPoints<Point> q_cut_points(const QBezierCurveOf<Point>& curve, const ScalarOf<Point>& t);

/// Bound on the error of a coordinate of q_cut_points, model units, as q_evaluation_error.
template <class Point>
double q_cut_error(const QBezierCurveOf<Point>& curve, double t);

template <class Point>
struct QHalves {
  QBezierCurveOf<Point> left;   ///< over [a, t]
  QBezierCurveOf<Point> right;  ///< over [t, b]
};

/// The two pieces of a curve, with the same q1, q2.
///
/// throws       InvalidInput also if the basis over [a, t] or [t, b] does not exist, with the
///              reason: Theorem 5.1 states no condition, but needs q1^i a != q2^i b on the
///              pieces, too. With q1 / q2 = 2 on [0, 1], [1/2, 1] is not admissible
///
/// Source: Disibuyuk 2022, Theorem 5.1.
template <class Point>
QHalves<Point> subdivide(const QBezierCurveOf<Point>& curve, const ScalarOf<Point>& t);

/// The 2^levels pieces of recursive midpoint subdivision, in order. Their control polygons converge
/// uniformly to the curve; the distance shrinks by 2 a level, and by 4 for q1 = q2.
///
/// levels       0..kMaxQLevels
/// throws       InvalidInput if levels is out of range, and as `subdivide`
///
/// Source: Disibuyuk 2022, Theorem 5.2; the rates are measured, the paper states none.
template <class Point>
std::vector<QBezierCurveOf<Point>> midpoint_pieces(const QBezierCurveOf<Point>& curve, int levels);

/// A million pieces.
inline constexpr int kMaxQLevels = 20;

}  // namespace blossom
