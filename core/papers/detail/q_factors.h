// SPDX-License-Identifier: LGPL-2.1-or-later
// (q1,q2)-numbers and the differences q1^i u - q2^i v, over any scalar.
//
// All formulas of (q1,q2)-blossoms are products and quotients of these differences, so their
// accuracy is that of the whole.

#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

#include "core/math/detail/bernstein.h"
#include "core/math/roundoff.h"
#include "core/papers/q_numbers.h"

namespace blossom::detail {

/// [0] .. [highest], by Horner's rule.
template <class Scalar>
std::vector<Scalar> q_integers(int highest, const QParametersOf<Scalar>& q) {
  std::vector<Scalar> integers(index(highest + 1), Scalar(0));
  Scalar power(1);
  for (int i = 1; i <= highest; ++i, power *= q.q1)
    integers[index(i)] = integers[index(i - 1)] * q.q2 + power;
  return integers;
}

/// [n,0] .. [n,n] by Pascal's recursion (2.1).
template <class Scalar>
std::vector<Scalar> q_binomial_row(int n, const QParametersOf<Scalar>& q) {
  const std::vector<Scalar> q1 = powers(q.q1, n), q2 = powers(q.q2, n);
  std::vector<Scalar> row(index(n + 1), Scalar(0));
  row[0] = Scalar(1);
  for (int level = 1; level <= n; ++level) {
    row[index(level)] = row[index(level - 1)];
    for (int k = level - 1; k > 0; --k) {
      Scalar from_k = q1[index(k)] * row[index(k)];
      Scalar from_before = q2[index(level - k)] * row[index(k - 1)];
      row[index(k)] = from_k + from_before;
    }
  }
  return row;
}

/// q^0, q^0 q^1, q^0 q^1 q^2, ..: entry k is q^(k(k-1)/2), k = 0..n.
template <class Scalar>
std::vector<Scalar> triangular_powers(const Scalar& q, int n) {
  std::vector<Scalar> result(index(n + 1), Scalar(1));
  Scalar power(1);
  for (int k = 2; k <= n; ++k) {
    power *= q;
    result[index(k)] = result[index(k - 1)] * power;
  }
  return result;
}

/// The right side of (2.3) for k = 0..n.
template <class Scalar>
std::vector<Scalar> diagonal_factors(int n, const QParametersOf<Scalar>& q) {
  const std::vector<Scalar> q1 = triangular_powers(q.q1, n), q2 = triangular_powers(q.q2, n);
  std::vector<Scalar> factors = q_binomial_row(n, q);
  for (int k = 0; k <= n; ++k) factors[index(k)] *= q1[index(k)] * q2[index(n - k)];
  return factors;
}

/// Powers of q1 and q2 up to some exponent, and the differences made of them.
template <class Scalar>
class QFactors {
 public:
  QFactors(int highest, const QParametersOf<Scalar>& q)
      : q1_(powers(q.q1, highest)),
        q2_(powers(q.q2, highest)),
        integers_(q_integers(highest, q)),
        step_(q.q1 - q.q2),
        same_sign_(!(q.q1 < 0 && q.q2 > 0) && !(q.q1 > 0 && q.q2 < 0)) {}

  const Scalar& q1(int i) const { return q1_[index(i)]; }
  const Scalar& q2(int i) const { return q2_[index(i)]; }

  /// q1^i u - q2^i v. For q1 and q2 of one sign as (q1 - q2) [i] u - q2^i (v - u), which has no
  /// cancellation where the basis is not negative.
  Scalar difference(int i, const Scalar& u, const Scalar& v) const {
    if (!same_sign_) return Scalar(q1(i) * u - q2(i) * v);
    return Scalar(step_ * integers_[index(i)] * u - q2(i) * (v - u));
  }

  /// (q1^i q2^j u - q1^j q2^i v) / (q1 q2)^k
  Scalar mixed_difference(int i, int j, int k, const Scalar& u, const Scalar& v) const {
    Scalar result = i >= j ? difference(i - j, u, v) : Scalar(-difference(j - i, v, u));
    const int common = std::min(i, j) - k;
    if (common > 0) result *= q1(common) * q2(common);
    if (common < 0) result /= q1(-common) * q2(-common);
    return result;
  }

  /// Sum of the absolute values of what `difference` adds up. With u = 2^-53, difference() is off
  /// by at most (2 i + 4) u of it: i roundings of a power or 2 i of an integer, four single ones.
  Scalar difference_size(int i, const Scalar& u, const Scalar& v) const {
    using std::abs;
    if (!same_sign_) return Scalar(abs(q1(i) * u) + abs(q2(i) * v));
    return Scalar(abs(step_ * integers_[index(i)] * u) + abs(q2(i) * (v - u)));
  }

  /// The same for `mixed_difference`, which has up to 2 |common| + 2 roundings more.
  Scalar mixed_difference_size(int i, int j, int k, const Scalar& u, const Scalar& v) const {
    Scalar result = i >= j ? difference_size(i - j, u, v) : difference_size(j - i, v, u);
    using std::abs;
    const int common = std::min(i, j) - k;
    if (common > 0) result *= abs(q1(common) * q2(common));
    if (common < 0) result /= abs(q1(-common) * q2(-common));
    return result;
  }

  /// True if q1^i u = q2^i v; in floating point, also if they cannot be told apart.
  bool vanishes(int i, const Scalar& u, const Scalar& v) const {
    const Scalar value = difference(i, u, v);
    if constexpr (std::is_floating_point_v<Scalar>)
      return std::abs(value) <= (2 * i + 4) * kUnitRoundoff * difference_size(i, u, v);
    else
      return value == 0;
  }

 private:
  std::vector<Scalar> q1_;
  std::vector<Scalar> q2_;
  std::vector<Scalar> integers_;
  Scalar step_;
  bool same_sign_;
};

}  // namespace blossom::detail
