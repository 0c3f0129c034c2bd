// SPDX-License-Identifier: LGPL-2.1-or-later
// The (q1,q2)-Bernstein basis over an interval, and Marsden's identity for it.
//
//   B_k^n(x; [a,b]; q1,q2) = [n,k] prod_{i<k} (q1^i a - q2^i x) prod_{i<n-k} (q1^i x - q2^i b)
//                            / prod_{i<n} (q1^i a - q2^i b)
//
// Special cases: q1 = q2 is the classical basis; q2 = 1 is the q-basis of Simeonov, Zafiris and
// Goldman, on [0, 1] that of Oruc and Phillips; [0, 1] is the (p,q)-basis of Mursaleen and others.
//
// `Scalar` is double or boost::multiprecision::cpp_rational. Doubles have no stated bound here;
// values of curves do, see `q_evaluation_error`.

#pragma once

#include <vector>

#include "core/math/interval.h"
#include "core/papers/q_numbers.h"

namespace blossom {

/// B_0^n(x) .. B_n^n(x).
///
///   (1) their sum is 1
///   (2) sum_k (a + q2^(n-k) [k] / [n] (b - a)) B_k == x for n >= 1
///   (3) B_k(w x; [w a, w b]) == B_k(x; [a, b]) for w != 0; but not for translations
///   (4) not negative on [a, b] for the safe parameters of q_basis_obstacle; elsewhere they may
///       change their sign there
///
/// n            0..kMaxDegree
/// x            any real; outside [a, b] extrapolates
/// returns      n + 1 values, dimensionless
/// throws       InvalidInput if the basis does not exist, with the reason, or a value is not finite
/// cost         O(n^2)
///
/// Source: Disibuyuk 2022, (3.4), Propositions 4.1 and 4.3; the printed (4.2) has a minus for the
/// plus in (2).
template <class Scalar>
std::vector<Scalar> q_bernstein(int n, const Scalar& x, const IntervalOf<Scalar>& interval,
                                const QParametersOf<Scalar>& q);

/// The functions of Theorem 3.1, which lead from the diagonal of a blossom to the basis:
///
///   P(x) = sum_{k=0..m} P_{m,k}(x) B~_k^{n,m}(x)
///   P_{m,k}(x) = p((q1^(n-1) x, q2^(n-1)), .., (q1^m x, q2^m),
///                  (q1^(n-1) a, q2^(n-1)), .., (q1^(n-m+k) a, q2^(n-m+k)),
///                  (q1^(k-1) b, q2^(k-1)), .., (b, 1))
///   B~_k^{n,m}(x) = [m,k] prod_{i<k} (q1^(n-m+i) a - q2^(n-m+i) x) prod_{i<m-k} (q1^i x - q2^i b)
///                   / prod_{i=n-m..n-1} (q1^i a - q2^i b)
///
/// m            0..n; n gives the basis itself
/// returns      m + 1 values
/// throws       InvalidInput as above, and if m is out of range
///
/// Source: Disibuyuk 2022, Theorem 3.1.
template <class Scalar>
std::vector<Scalar> q_partial_bernstein(int n, int m, const Scalar& x,
                                        const IntervalOf<Scalar>& interval,
                                        const QParametersOf<Scalar>& q);

/// The two recurrences, with F_i(u, v) = q1^i u - q2^i v:
///
///   Forward:   B_k^n = (q1^(n-k) F_(k-1)(a, x) B_(k-1)^(n-1) + q2^k F_(n-k-1)(x, b) B_k^(n-1))
///                      / F_(n-1)(a, b)
///   Backward:  B_k^n = (q2^(n-k) F_(k-1)(a, x) B_(k-1)^(n-1) + q1^k F_(n-k-1)(x, b) B_k^(n-1))
///                      / F_(n-1)(a, b)
enum class QRecurrence {
  Forward,   ///< (3.5)
  Backward,  ///< (3.6)
};

/// The basis by a recurrence from degree 0. Arguments, result and refusals as q_bernstein.
///
/// cost         O(n^2)
///
/// Source: Disibuyuk 2022, (3.5) and (3.6).
template <class Scalar>
std::vector<Scalar> q_bernstein_by(QRecurrence recurrence, int n, const Scalar& x,
                                   const IntervalOf<Scalar>& interval,
                                   const QParametersOf<Scalar>& q);

/// The terms of Marsden's identity,
///
///   prod_{i<n} (q1^i t - q2^i x) / prod_{i<n} (q1^i a - q2^i b) = sum_k term_k
///   term_k = (-1)^k (q1 q2)^(k(k-1)/2) / (q2^(k(n-1)) [n,n-k] at 1/q1, 1/q2)
///            B_(n-k)^n(x; [(q1/q2)^(n-1) a, b]; 1/q1, 1/q2) B_k^n(t; [a,b]; q1,q2)
///
/// returns      n + 1 terms
/// throws       InvalidInput as q_bernstein, and if q1 or q2 is 0
///
/// Source: Disibuyuk 2022, Theorem 3.8; the printed (3.14) and (3.15) have [n,n-k] at q1, q2, which
/// is right only for n = 1 or (q1 q2)^(k(n-k)) = 1.
template <class Scalar>
std::vector<Scalar> q_marsden_terms(int n, const Scalar& t, const Scalar& x,
                                    const IntervalOf<Scalar>& interval,
                                    const QParametersOf<Scalar>& q);

/// The left side of Marsden's identity; arguments and refusals as above, but q1 q2 = 0 is allowed.
template <class Scalar>
Scalar q_marsden_product(int n, const Scalar& t, const Scalar& x,
                         const IntervalOf<Scalar>& interval, const QParametersOf<Scalar>& q);

}  // namespace blossom
