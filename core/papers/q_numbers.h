// SPDX-License-Identifier: LGPL-2.1-or-later
// (q1,q2)-integers, factorials and binomials, and which parameters have a blossom and a basis.
//
// They take the place of the ordinary numbers when the diagonal of a blossom is stretched by powers
// of q1 and q2 (`core/papers/q_blossom.h`). At q1 = q2 = 1 they are the ordinary ones; q1 = q2
// gives those times a power.
//
// Notation: [n] integer, [n]! factorial, [n,k] binomial coefficient, all for one pair q1, q2.
// 0^0 is 1. The functions whose names begin with q_ exist for double and for
// boost::multiprecision::cpp_rational, where they are exact; both are named `Scalar`.

#pragma once

#include <string>
#include <vector>

#include "core/math/interval.h"

namespace blossom {

/// The two parameters. Curves, bases and control points depend on q1 / q2 alone; blossoms and
/// intermediate points of algorithms differ by powers of q2.
template <class Scalar>
struct QParametersOf {
  Scalar q1{1};
  Scalar q2{1};

  friend bool operator==(const QParametersOf&, const QParametersOf&) = default;
};

using QParameters = QParametersOf<double>;

/// [n] = sum_{k=0..n-1} q1^k q2^(n-k-1), which is (q1^n - q2^n) / (q1 - q2) for q1 != q2.
///
/// n            0..kMaxDegree
/// throws       InvalidInput if n is out of range or q is not finite; so do those below
///
/// Source: Disibuyuk 2022, section 2; the sum, since the quotient is 0/0 for q1 = q2.
template <class Scalar>
Scalar q_integer(int n, const QParametersOf<Scalar>& q);

/// [n]! = [n] [n-1] .. [1], and 1 for n = 0.
template <class Scalar>
Scalar q_factorial(int n, const QParametersOf<Scalar>& q);

/// [n,0] .. [n,n] by the Pascal recursion
///
///   [n,k] = q1^k [n-1,k] + q2^(n-k) [n-1,k-1]
///
///   (1) [n,k] = [n,n-k]
///   (2) [n,k] [k]! [n-k]! = [n]!
///   (3) [n,k] at 1/q1, 1/q2 = (q1 q2)^(-k(n-k)) [n,k] at q1, q2
///
/// Source: Disibuyuk 2022, (2.1); the quotient of factorials is 0/0 for q1 = -q2.
template <class Scalar>
std::vector<Scalar> q_binomials(int n, const QParametersOf<Scalar>& q);

/// The divisors in the blossoms of x^k y^(n-k), k = 0..n:
///
///   q1^(k(k-1)/2) q2^((n-k)(n-k-1)/2) [n,k]
///     = sum over |e| = k of prod_{i=1..n} q1^((n-i) e_i) q2^((n-i) (1-e_i)),  e_i = 0 or 1
///
/// Source: Disibuyuk 2022, Lemma 2.3.
template <class Scalar>
std::vector<Scalar> q_diagonal_factors(int n, const QParametersOf<Scalar>& q);

/// Why not every polynomial of this degree has a (q1,q2)-blossom; empty if every one has. The
/// blossom exists if n <= 1, or q1 q2 != 0 and not (q1 = -q2 with n even).
///
/// throws       InvalidInput if the degree is not 0..kMaxDegree or a number is not finite
///
/// Source: Disibuyuk 2022, Corollary 2.4, corrected: the printed statement refuses q1 = 0 and
/// q2 = 0 for n = 1, too, where no power of them occurs.
template <class Scalar>
std::string q_blossom_obstacle(int degree, const QParametersOf<Scalar>& q);

/// Why there is no (q1,q2)-Bernstein basis of this degree over the interval; empty if there is
/// one. It needs a blossom, and q1^i a != q2^i b for i = 0..n-1. In double a difference that
/// drowns in its own rounding counts as 0.
///
/// Safe, and closed under subdivision: 0 <= a < b and -1 < q1/q2 <= 1, q1 != 0; or a < b <= 0 with
/// q2/q1 in that range. There the basis is not negative on [a, b].
///
/// throws       InvalidInput if the degree is not 0..kMaxDegree or a number is not finite
///
/// Source: Disibuyuk 2022, (3.4).
template <class Scalar>
std::string q_basis_obstacle(int degree, const IntervalOf<Scalar>& interval,
                             const QParametersOf<Scalar>& q);

}  // namespace blossom
