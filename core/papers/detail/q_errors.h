// SPDX-License-Identifier: LGPL-2.1-or-later
// Running error bounds of the triangular evaluation algorithms, to first order, doubled. The bound
// stands for the largest coordinate.
//
// u = 2^-53; counts of roundings as in `core/papers/detail/q_factors.h`.

#pragma once

#include <cmath>
#include <cstdlib>
#include <span>
#include <vector>

#include "core/math/roundoff.h"
#include "core/papers/detail/q_blossom.h"

namespace blossom::detail {

/// The errors of the weights alpha and beta, absolute.
inline Step<double> step_error(const QFactors<double>& factors, const Interval& interval, double x,
                               int s, int r, int k) {
  const double divisor = std::abs(factors.difference(r, interval.from, interval.to));
  const double divisor_error =
      (2 * r + 4) * factors.difference_size(r, interval.from, interval.to) / divisor + 1;
  const auto error = [&](int i, int j, double u, double v) {
    const double count = 2 * std::abs(i - j) + 6 + 2 * std::abs(std::min(i, j) - k);
    return kUnitRoundoff / divisor *
           (count * factors.mixed_difference_size(i, j, k, u, v) +
            std::abs(factors.mixed_difference(i, j, k, u, v)) * divisor_error);
  };
  return {error(s, k, x, interval.to), error(r + k, s, interval.from, x)};
}

/// Bounds on the errors of all levels of evaluation_levels, when the points are off by `errors`.
template <class Point>
std::vector<std::vector<double>> evaluation_errors(const std::vector<Point>& points,
                                                   std::vector<double> errors,
                                                   const Interval& interval, const QParameters& q,
                                                   double x, std::span<const int> permutation) {
  const QFactors<double> factors(static_cast<int>(points.size()) - 1, q);
  const QLevels<Point> levels = evaluation_levels(points, interval, q, x, permutation);
  std::vector<std::vector<double>> result{std::move(errors)};
  for (std::size_t r = 0; r + 1 < levels.size(); ++r) {
    std::vector<double> next;
    for (std::size_t k = 0; k + 1 < levels[r].size(); ++k) {
      const int s = permutation[r] - 1, row = static_cast<int>(r), column = static_cast<int>(k);
      const auto [alpha, beta] = evaluation_step(factors, interval, x, s, row, column);
      const auto [alpha_error, beta_error] = step_error(factors, interval, x, s, row, column);
      const double size_k = max_norm(levels[r][k]), size_next = max_norm(levels[r][k + 1]);
      // Inherited; wrong weights; two products and their sum.
      next.push_back(std::abs(alpha) * result[r][k] + std::abs(beta) * result[r][k + 1] +
                     2 * (alpha_error * size_k + beta_error * size_next) +
                     4 * kUnitRoundoff * (std::abs(alpha) * size_k + std::abs(beta) * size_next));
    }
    result.push_back(std::move(next));
  }
  return result;
}

}  // namespace blossom::detail
