// SPDX-License-Identifier: LGPL-2.1-or-later
// Random exact data for the tests of (q1,q2)-blossoms: small fractions, curves, admissible bases.

#pragma once

#include <algorithm>
#include <vector>

#include "core/papers/q_curve.h"
#include "tests/support/exact.h"
#include "tests/support/random.h"

namespace blossom::testing {

using ExactPoint2 = Vec<Rational, 2>;
using ExactPoint3 = Vec<Rational, 3>;
using ExactCurve = QBezierCurveOf<ExactPoint3>;
using ExactQ = QParametersOf<Rational>;
using ExactInterval = IntervalOf<Rational>;

/// p / q with |p| <= 9 and q = 1..5.
inline Rational fraction(Random& random) {
  const int above = pick(random, -9, 9), below = pick(random, 1, 5);
  return Rational(above) / Rational(below);
}

inline Rational nonzero_fraction(Random& random) {
  Rational value = fraction(random);
  while (value == 0) value = fraction(random);
  return value;
}

inline std::vector<ExactPoint3> exact_points(Random& random, int degree) {
  std::vector<ExactPoint3> points;
  for (int k = 0; k <= degree; ++k)
    points.push_back({fraction(random), fraction(random), fraction(random)});
  return points;
}

inline std::vector<ExactPoint2> exact_pairs(Random& random, int count) {
  std::vector<ExactPoint2> pairs;
  for (int k = 0; k < count; ++k) pairs.push_back({fraction(random), fraction(random)});
  return pairs;
}

/// A curve of random points over a random interval with random parameters that have a basis.
inline ExactCurve exact_curve(Random& random, int degree) {
  ExactCurve curve{exact_points(random, degree), {}, {}};
  do {
    curve.interval = {fraction(random), fraction(random)};
    curve.q = {nonzero_fraction(random), nonzero_fraction(random)};
  } while (!q_basis_obstacle(degree, curve.interval, curve.q).empty());
  return curve;
}

/// 0 <= a < b and -1 < q1/q2 <= 1: safe under subdivision, too.
inline ExactCurve safe_curve(Random& random, int degree) {
  ExactCurve curve{exact_points(random, degree), {}, {}};
  curve.interval.from = abs(fraction(random));
  curve.interval.to = curve.interval.from + abs(nonzero_fraction(random));
  curve.q.q2 = nonzero_fraction(random);
  const int above = pick(random, 1, 8);
  curve.q.q1 = curve.q.q2 * Rational(above) / Rational(pick(random, 0, 1) == 0 ? 8 : -9);
  return curve;
}

inline std::vector<std::vector<int>> all_permutations(int n) {
  std::vector<std::vector<int>> list;
  std::vector<int> permutation = identity_permutation(n);
  do {
    list.push_back(permutation);
  } while (std::next_permutation(permutation.begin(), permutation.end()));
  return list;
}

inline Rational power(const Rational& base, int exponent) {
  Rational result(1);
  for (int i = 0; i < std::abs(exponent); ++i) result *= base;
  return exponent < 0 ? Rational(Rational(1) / result) : result;
}

/// sum_k c_k x^k y^(n-k), term by term.
inline ExactPoint3 homogeneous_value(const std::vector<ExactPoint3>& coefficients,
                                     const Rational& x, const Rational& y) {
  const int n = static_cast<int>(coefficients.size()) - 1;
  ExactPoint3 sum{};
  for (int k = 0; k <= n; ++k) {
    const Rational weight = power(x, k) * power(y, n - k);
    sum += coefficients[static_cast<std::size_t>(k)] * weight;
  }
  return sum;
}

}  // namespace blossom::testing
