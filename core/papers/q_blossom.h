// SPDX-License-Identifier: LGPL-2.1-or-later
// The homogeneous (q1,q2)-blossom of a polynomial curve.
//
// P(x) = sum_k c_k x^k of degree n is made homogeneous, P(x, y) = sum_k c_k x^k y^(n-k). Exactly
// one function p of n pairs (x_i, y_i) is symmetric, linear in each pair, and
//
//   p((q1^(n-1) x, q2^(n-1) y), .., (q1 x, q2 y), (x, y)) == P(x, y).
//
// At q1 = q2 = 1 and y_i = 1 it is the classical blossom of `core/blossom/curve_blossom.h`. Its
// values at the stretched ends of an interval are the control points of the (q1,q2)-Bezier curve.
//
// Every function here is for points of two, three and four coordinates, of double or of
// boost::multiprecision::cpp_rational; the parameters have the scalar of the points.
//
// Notation: n degree; [a, b] interval; [n,k] as in `core/papers/q_numbers.h`; sigma a permutation
// of 1..n.

#pragma once

#include <span>
#include <vector>

#include "core/forms/curve.h"
#include "core/math/roundoff.h"
#include "core/math/vec.h"
#include "core/papers/q_numbers.h"

namespace blossom {

template <class Point>
using ScalarOf = typename Point::scalar_type;
/// An argument (x, y) of a homogeneous blossom.
template <class Point>
using PairOf = Vec<ScalarOf<Point>, 2>;

/// The (q1,q2)-blossom of a curve at n arguments.
///
///   p = sum_k c_k phi_k / (q1^(k(k-1)/2) q2^((n-k)(n-k-1)/2) [n,k])
///   phi_k: sum over all choices of k arguments, the product of their x and of the others' y
///
///   (1) symmetric:  any order of the arguments gives the same point
///   (2) linear:     p(.., s (x, y) + t (u, v), ..) == s p(.., (x, y), ..) + t p(.., (u, v), ..)
///   (3) diagonal:   p((q1^(n-1) x, q2^(n-1)), .., (x, 1)) == P(x)
///
/// curve        n + 1 coefficients, model units; centre and scale are expanded first
/// arguments    n pairs (x_i, y_i), any reals
/// returns      a point, model units
/// throws       InvalidInput if there is no such blossom (q_blossom_obstacle has the reason), the
///              number of arguments is not n, or a value is not finite; in double also if a divisor
///              leaves its range
/// accuracy     q_blossom_error(n) times q_blossom_scale, for centre 0 and scale 1
/// cost         O(n^2)
///
/// Source: Disibuyuk 2022, Theorem 2.2 with Lemma 2.3.
template <class Point>
Point q_blossom_at(const MonomialCurveOf<Point>& curve, const QParametersOf<ScalarOf<Point>>& q,
                   std::span<const PairOf<Point>> arguments);

/// The same sums with all terms replaced by their absolute values, the largest of all coordinates.
/// Model units.
template <class Point>
double q_blossom_scale(const MonomialCurveOf<Point>& curve, const QParameters& q,
                       std::span<const Vec2> arguments);

/// The blossom at the stretched ends of an interval,
///
///   b_k = p((q1^(n-1) a, q2^(n-1) c), .., (q1^k a, q2^k c), (q1^(k-1) b, q2^(k-1) c), .., (b, c)),
///
/// k = 0..n. For c = 1 these are the control points over [a, b] (the dual functionals); for other c
/// those of P(x, c), and the start of one more algorithm for the same blossom.
///
/// c            not 0
/// returns      n + 1 points, model units
/// throws       InvalidInput as q_blossom_at; or if the basis over [a, b] does not exist
///              (q_basis_obstacle has the reason), or c is 0 or not finite
/// accuracy     q_blossom_error(n) times q_blossom_scale at the same arguments
/// cost         O(n^3)
///
/// Source: Disibuyuk 2022, Theorem 2.5 and Corollary 3.7.
template <class Point>
std::vector<Point> q_control_points(const MonomialCurveOf<Point>& curve,
                                    const IntervalOf<ScalarOf<Point>>& interval,
                                    const QParametersOf<ScalarOf<Point>>& q,
                                    const ScalarOf<Point>& c = ScalarOf<Point>(1));

/// The arguments of b_k above.
///
/// throws       InvalidInput if k is not 0..n, n not 0..kMaxDegree, or a value is not finite
template <class Scalar>
std::vector<Vec<Scalar, 2>> q_control_arguments(int n, int k, const IntervalOf<Scalar>& interval,
                                                const QParametersOf<Scalar>& q,
                                                const Scalar& c = Scalar(1));

/// Levels of an algorithm: levels[r][k] is b_k^r, r = 0..n, k = 0..n-r.
template <class Point>
using QLevels = std::vector<std::vector<Point>>;

/// The recursive blossoming algorithm from b_k^0 = `points`:
///
///   b_k^(r+1) = alpha b_k^r + beta b_(k+1)^r
///   alpha = (q2^k x c - q1^k b y) / (q1^k q2^k c D_r)              D_r = q1^r a - q2^r b
///   beta  = (q1^(r+k) a y - q2^(r+k) x c) / (q1^k q2^k c D_r)      (x, y) = arguments[r]
///
///   (1) b_k^r == p((q1^(n-1) a, q2^(n-1) c), .., (q1^(r+k) a, q2^(r+k) c),
///                  (x_1, y_1), .., (x_r, y_r), (q1^(k-1) b, q2^(k-1) c), .., (b, c))
///   (2) b_0^n == p((x_1, y_1), .., (x_n, y_n)), whatever c
///
/// points       q_control_points(curve, interval, q, c): n + 1 points, model units
/// throws       InvalidInput as q_control_points, and if the number of arguments is not n
/// cost         O(n^2)
///
/// Source: Disibuyuk 2022, Theorem 2.5.
template <class Point>
QLevels<Point> q_blossom_levels(const std::vector<Point>& points,
                                const IntervalOf<ScalarOf<Point>>& interval,
                                const QParametersOf<ScalarOf<Point>>& q,
                                std::span<const PairOf<Point>> arguments,
                                const ScalarOf<Point>& c = ScalarOf<Point>(1));

/// The evaluation algorithm of a permutation: the recursion above at x_r = q1^(sigma_r - 1) x,
/// y_r = q2^(sigma_r - 1) c. The steps do not depend on c:
///
///   alpha = (q1^s q2^k x - q1^k q2^s b) / (q1^k q2^k D_r)           s = sigma_(r+1) - 1
///   beta  = (q1^(r+k) q2^s a - q1^s q2^(r+k) x) / (q1^k q2^k D_r)
///
///   (1) b_0^n == P(x, c), for each of the n! permutations
///   (2) alpha + beta == 1 for q2 = 1
///   (3) b_k^r at q1, q2 == q2^E b_k^r at q1 / q2, 1, with
///       E = sum_{i<=r} (sigma_i - 1) - (r k + r (r - 1) / 2)
///
/// points       n + 1 points b_k^0, model units
/// permutation  sigma_1..sigma_n: the numbers 1..n in any order
/// throws       InvalidInput as q_control_points, and if the permutation is none
/// accuracy     q_evaluation_error
/// cost         O(n^2)
///
/// Source: Disibuyuk 2022, Corollary 2.6 and Theorem 3.3. The paper takes the algorithms for a new
/// family in q2; (3) is what really changes with q2.
template <class Point>
QLevels<Point> q_evaluation_levels(const std::vector<Point>& points,
                                   const IntervalOf<ScalarOf<Point>>& interval,
                                   const QParametersOf<ScalarOf<Point>>& q,
                                   const ScalarOf<Point>& x, std::span<const int> permutation);

/// Bound on the error of a coordinate of the last level, model units, by adding up the roundings
/// of each step to first order, doubled.
///
/// Source: running error analysis, Higham 2002, section 3.3.
template <class Point>
double q_evaluation_error(const std::vector<Point>& points, const Interval& interval,
                          const QParameters& q, double x, std::span<const int> permutation);

/// One of infinitely many de Casteljau algorithms for a classical Bezier curve over [a, b]:
///
///   b_k^(r+1) = q^s (b - x) / (q^(r+k) (b - a)) b_k^r + q^s (x - a) / (q^k (b - a)) b_(k+1)^r
///
/// with s = sigma_(r+1) - 1. It ends in b_0^n = sum_k points[k] B_k^n((x - a) / (b - a)) for every
/// permutation and every q; the identity and q = 1 give de Casteljau's own.
///
/// points       n + 1 Bezier points, model units
/// q            not 0
/// throws       InvalidInput if the degree is not 0..kMaxDegree, q is 0, a = b, the permutation is
///              none, or a value is not finite
/// cost         O(n^2)
///
/// Source: Disibuyuk 2022, Theorem 3.9.
template <class Point>
QLevels<Point> classical_levels(const std::vector<Point>& points,
                                const IntervalOf<ScalarOf<Point>>& interval,
                                const ScalarOf<Point>& q, const ScalarOf<Point>& x,
                                std::span<const int> permutation);

/// sigma_r = r, and sigma_r = n + 1 - r.
std::vector<int> identity_permutation(int n);
std::vector<int> reversed_permutation(int n);

/// Bound on the error of q_blossom_at and q_control_points, relative to q_blossom_scale. A divisor
/// rounds up to n^2 / 2 + n^2 / 4 + 2 n + 2 times, phi_k 2 n times and, at the ends of an interval,
/// n (n - 1) / 2 times more in its arguments; the sum n + 2 times.
constexpr double q_blossom_error(int degree) {
  return (1.25 * degree * degree + 5 * degree + 6) * kUnitRoundoff;
}

}  // namespace blossom
