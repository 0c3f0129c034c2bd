// SPDX-License-Identifier: LGPL-2.1-or-later
// (q1,q2)-Bezier form to classical and monomial form over any scalar, without preconditions.

#pragma once

#include <utility>
#include <vector>

#include "core/math/grid.h"
#include "core/math/matrix.h"
#include "core/papers/detail/q_blossom.h"

namespace blossom::detail {

/// A linear factor by its values at the ends of the interval.
template <class Scalar>
struct LinearFactor {
  Scalar at_a;
  Scalar at_b;
};

/// The coefficients of s^j (1-s)^(m-j), times one more factor.
template <class Scalar>
void multiply(std::vector<Scalar>& scaled, const LinearFactor<Scalar>& factor) {
  scaled.push_back(Scalar(0));
  for (std::size_t j = scaled.size() - 1; j > 0; --j) {
    Scalar stays = scaled[j] * factor.at_a;
    Scalar moves = scaled[j - 1] * factor.at_b;
    scaled[j] = stays + moves;
  }
  scaled[0] *= factor.at_a;
}

/// Column k of the conversion matrix from [n,k] and factor(k, i), i < n: the i-th factor of B_k
/// over its divisor D_i.
template <class Scalar, class FactorOf>
Grid<Scalar> product_matrix(int n, const std::vector<Scalar>& binomials, FactorOf factor) {
  Grid<Scalar> matrix(n + 1, n + 1);
  for (int k = 0; k <= n; ++k) {
    std::vector<Scalar> scaled{Scalar(1)};
    for (int i = 0; i < n; ++i) multiply(scaled, factor(k, i));
    for (int j = 0; j <= n; ++j)
      matrix(j, k) = scaled[index(j)] * binomials[index(k)] / Scalar(binomial(n, j));
  }
  return matrix;
}

template <class Scalar>
Grid<Scalar> conversion_matrix(int n, const IntervalOf<Scalar>& interval,
                               const QParametersOf<Scalar>& q) {
  const auto& [a, b] = interval;
  const QFactors<Scalar> factors(n, q);
  return product_matrix(n, q_binomial_row(n, q), [&, &a = a, &b = b](int k, int i) {
    const Scalar divisor = factors.difference(i, a, b);
    if (i < k)
      return LinearFactor<Scalar>{Scalar(factors.difference(i, a, a) / divisor), Scalar(1)};
    return LinearFactor<Scalar>{Scalar(factors.difference(i - k, a, b) / divisor),
                                Scalar(factors.difference(i - k, b, b) / divisor)};
  });
}

/// The same with sizes for differences: entries bound those above and, times the number of
/// roundings, their errors.
inline Grid<double> conversion_sizes(int n, const Interval& interval, const QParameters& q) {
  const auto& [a, b] = interval;
  const QFactors<double> factors(n, q);
  const std::vector<double> binomials =
      q_binomial_row(n, QParameters{std::abs(q.q1), std::abs(q.q2)});
  return product_matrix(n, binomials, [&, &a = a, &b = b](int k, int i) {
    const double divisor = std::abs(factors.difference(i, a, b));
    const double loss = factors.difference_size(i, a, b) / divisor;
    const auto size = [&](int j, double u, double v) {
      return factors.difference_size(j, u, v) / divisor * loss;
    };
    if (i < k) return LinearFactor<double>{size(i, a, a), 1};
    return LinearFactor<double>{size(i - k, a, b), size(i - k, b, b)};
  });
}

/// The plain coefficients by the blossom at k copies of (1, 0) and n - k of (0, 1).
template <class Point, class Scalar = typename Point::scalar_type>
std::vector<Point> monomial_coefficients(const std::vector<Point>& points,
                                         const IntervalOf<Scalar>& interval,
                                         const QParametersOf<Scalar>& q) {
  const int n = static_cast<int>(points.size()) - 1;
  const QFactors<Scalar> factors(n, q);
  const std::vector<Scalar> weights = diagonal_factors(n, q);
  const Vec<Scalar, 2> direction{Scalar(1), Scalar(0)}, origin{Scalar(0), Scalar(1)};
  std::vector<Point> coefficients;
  for (int k = 0; k <= n; ++k) {
    const QLevels<Point> levels = triangle_levels(points, [&](int r, int column) {
      return blossom_step(factors, interval, Scalar(1), r < k ? direction : origin, r, column);
    });
    coefficients.push_back(levels.back()[0] * weights[index(k)]);
  }
  return coefficients;
}

/// The solution of matrix x = right by elimination with partial pivoting. The matrix is regular.
template <class Scalar, class Point>
std::vector<Point> solution(Grid<Scalar> matrix, std::vector<Point> right) {
  using std::abs;
  const int n = matrix.rows();
  for (int column = 0; column < n; ++column) {
    int pivot = column;
    for (int row = column + 1; row < n; ++row)
      if (abs(matrix(row, column)) > abs(matrix(pivot, column))) pivot = row;
    for (int j = 0; j < n; ++j) std::swap(matrix(pivot, j), matrix(column, j));
    std::swap(right[index(pivot)], right[index(column)]);
    for (int row = column + 1; row < n; ++row) {
      const Scalar factor = matrix(row, column) / matrix(column, column);
      for (int j = column; j < n; ++j) matrix(row, j) -= factor * matrix(column, j);
      right[index(row)] -= right[index(column)] * factor;
    }
  }
  for (int row = n - 1; row >= 0; --row) {
    for (int j = row + 1; j < n; ++j) right[index(row)] -= right[index(j)] * matrix(row, j);
    right[index(row)] *= Scalar(1) / matrix(row, row);
  }
  return right;
}

}  // namespace blossom::detail
