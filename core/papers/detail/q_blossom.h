// SPDX-License-Identifier: LGPL-2.1-or-later
// The formulas of (q1,q2)-blossoms over any scalar, without preconditions.

#pragma once

#include <span>
#include <vector>

#include "core/papers/detail/q_factors.h"
#include "core/papers/q_blossom.h"

namespace blossom::detail {

/// phi_0..phi_n of Theorem 2.2: the coefficients of z^k in prod_i (y_i + x_i z).
template <class Scalar>
std::vector<Scalar> symmetric_sums(std::span<const Vec<Scalar, 2>> arguments) {
  std::vector<Scalar> sums{Scalar(1)};
  for (const Vec<Scalar, 2>& pair : arguments) {
    sums.push_back(Scalar(0));
    for (std::size_t k = sums.size() - 1; k > 0; --k) {
      Scalar without = sums[k] * pair[1];
      Scalar with = sums[k - 1] * pair[0];
      sums[k] = without + with;
    }
    sums[0] *= pair[1];
  }
  return sums;
}

/// sum_k values_k weights_k
template <class Point>
Point weighted_sum(const std::vector<Point>& values,
                   const std::vector<typename Point::scalar_type>& weights) {
  Point sum = values[0] * weights[0];
  for (std::size_t k = 1; k < values.size(); ++k) sum += values[k] * weights[k];
  return sum;
}

/// The blossom at n arguments from plain coefficients and the divisors of Lemma 2.3.
template <class Point, class Scalar = typename Point::scalar_type>
Point homogeneous_blossom(const std::vector<Point>& coefficients,
                          const std::vector<Scalar>& divisors,
                          std::span<const Vec<Scalar, 2>> arguments) {
  std::vector<Scalar> weights = symmetric_sums(arguments);
  for (std::size_t k = 0; k < weights.size(); ++k) weights[k] /= divisors[k];
  return weighted_sum(coefficients, weights);
}

/// Coefficients of x^0..x^n, by Horner's rule in polynomials.
template <class Point>
std::vector<Point> plain_coefficients(const MonomialCurveOf<Point>& curve) {
  using Scalar = typename Point::scalar_type;
  if (curve.centre == 0 && curve.scale == 1) return curve.coefficients;
  const Scalar slope = Scalar(1) / Scalar(curve.scale);
  const Scalar shift = -Scalar(curve.centre) * slope;
  std::vector<Point> plain(curve.coefficients.size(), Point{});
  for (std::size_t i = curve.coefficients.size(); i-- > 0;) {
    for (std::size_t j = plain.size() - 1; j > 0; --j)
      plain[j] = plain[j] * shift + plain[j - 1] * slope;
    plain[0] = plain[0] * shift + curve.coefficients[i];
  }
  return plain;
}

/// (q1^(n-1) a, q2^(n-1) c), .., (q1^k a, q2^k c), (q1^(k-1) b, q2^(k-1) c), .., (b, c)
template <class Scalar>
std::vector<Vec<Scalar, 2>> control_arguments(int n, int k, const IntervalOf<Scalar>& interval,
                                              const QFactors<Scalar>& factors, const Scalar& c) {
  std::vector<Vec<Scalar, 2>> arguments(index(n));
  for (int i = n - 1, at = 0; i >= 0; --i, ++at) {
    const Scalar& end = i >= k ? interval.from : interval.to;
    arguments[index(at)][0] = factors.q1(i) * end;
    arguments[index(at)][1] = factors.q2(i) * c;
  }
  return arguments;
}

/// b_0^0..b_n^0 of Theorem 2.5.
template <class Point, class Scalar = typename Point::scalar_type>
std::vector<Point> control_points(const std::vector<Point>& coefficients,
                                  const IntervalOf<Scalar>& interval,
                                  const QParametersOf<Scalar>& q, const Scalar& c) {
  const int n = static_cast<int>(coefficients.size()) - 1;
  const QFactors<Scalar> factors(n, q);
  const std::vector<Scalar> divisors = diagonal_factors(n, q);
  std::vector<Point> points;
  for (int k = 0; k <= n; ++k) {
    const auto arguments = control_arguments(n, k, interval, factors, c);
    points.push_back(
        homogeneous_blossom(coefficients, divisors, std::span<const Vec<Scalar, 2>>(arguments)));
  }
  return points;
}

/// The two weights of one step of an algorithm.
template <class Scalar>
struct Step {
  Scalar alpha;
  Scalar beta;
};

/// All levels of a triangular algorithm; step(r, k) gives the weights of b_k^r and b_(k+1)^r.
template <class Point, class StepOf>
QLevels<Point> triangle_levels(const std::vector<Point>& points, StepOf step) {
  QLevels<Point> levels{points};
  for (int r = 0; levels.back().size() > 1; ++r) {
    const std::vector<Point>& from = levels.back();
    std::vector<Point> to;
    for (int k = 0; k + 1 < static_cast<int>(from.size()); ++k) {
      const auto weights = step(r, k);
      to.push_back(from[index(k)] * weights.alpha + from[index(k + 1)] * weights.beta);
    }
    levels.push_back(std::move(to));
  }
  return levels;
}

/// alpha and beta of (2.5). Source: Disibuyuk 2022, Theorem 2.5.
template <class Scalar>
Step<Scalar> blossom_step(const QFactors<Scalar>& factors, const IntervalOf<Scalar>& interval,
                          const Scalar& c, const Vec<Scalar, 2>& pair, int r, int k) {
  const Scalar x = pair[0] * c;
  const Scalar divisor =
      factors.q1(k) * factors.q2(k) * c * factors.difference(r, interval.from, interval.to);
  const Scalar alpha = factors.q2(k) * x - factors.q1(k) * interval.to * pair[1];
  const Scalar beta = factors.q1(r + k) * interval.from * pair[1] - factors.q2(r + k) * x;
  return {Scalar(alpha / divisor), Scalar(beta / divisor)};
}

/// alpha and beta of (2.6) and (3.11), with common powers of q1 q2 cancelled. s = sigma - 1.
template <class Scalar>
Step<Scalar> evaluation_step(const QFactors<Scalar>& factors, const IntervalOf<Scalar>& interval,
                             const Scalar& x, int s, int r, int k) {
  const Scalar divisor = factors.difference(r, interval.from, interval.to);
  return {Scalar(factors.mixed_difference(s, k, k, x, interval.to) / divisor),
          Scalar(factors.mixed_difference(r + k, s, k, interval.from, x) / divisor)};
}

template <class Point, class Scalar = typename Point::scalar_type>
QLevels<Point> evaluation_levels(const std::vector<Point>& points,
                                 const IntervalOf<Scalar>& interval, const QParametersOf<Scalar>& q,
                                 const Scalar& x, std::span<const int> permutation) {
  const QFactors<Scalar> factors(static_cast<int>(points.size()) - 1, q);
  return triangle_levels(points, [&](int r, int k) {
    return evaluation_step(factors, interval, x, permutation[index(r)] - 1, r, k);
  });
}

}  // namespace blossom::detail
