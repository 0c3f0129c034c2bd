// SPDX-License-Identifier: LGPL-2.1-or-later
// Products of small dense matrices with curves and nets of points.
//
// Sums run in ascending order, without skipping zeros, so that equal rows give equal bits.

#pragma once

#include <cassert>
#include <cstddef>
#include <span>
#include <vector>

#include "core/math/grid.h"

namespace blossom {

/// a b: (rows of a) x (columns of b); b may hold points.
template <class Scalar, class T>
Grid<T> product(const Grid<Scalar>& a, const Grid<T>& b) {
  assert(a.columns() == b.rows());
  Grid<T> result(a.rows(), b.columns());
  for (int i = 0; i < a.rows(); ++i) {
    const std::span<T> sums = row_of(result, i);
    for (int k = 0; k < a.columns(); ++k) {
      const Scalar& factor = a(i, k);
      const std::span<const T> row = row_of(b, k);
      for (std::size_t j = 0; j < row.size(); ++j)
        if (k == 0)
          sums[j] = factor * row[j];
        else
          sums[j] += factor * row[j];
    }
  }
  return result;
}

/// b a^T: (rows of b) x (rows of a); b may hold points.
template <class Scalar, class T>
Grid<T> product_transposed(const Grid<T>& b, const Grid<Scalar>& a) {
  assert(a.columns() == b.columns());
  Grid<T> result(b.rows(), a.rows());
  for (int i = 0; i < b.rows(); ++i) {
    const std::span<T> sums = row_of(result, i);
    const std::span<const T> row = row_of(b, i);
    for (int j = 0; j < a.rows(); ++j) {
      const std::span<const Scalar> factors = row_of(a, j);
      T sum = factors[0] * row[0];
      for (std::size_t k = 1; k < row.size(); ++k) sum += factors[k] * row[k];
      sums[static_cast<std::size_t>(j)] = sum;
    }
  }
  return result;
}

/// a b for a column b.
template <class Scalar, class T>
std::vector<T> product(const Grid<Scalar>& a, const std::vector<T>& b) {
  assert(a.columns() == static_cast<int>(b.size()));
  std::vector<T> result;
  result.reserve(static_cast<std::size_t>(a.rows()));
  for (int i = 0; i < a.rows(); ++i) {
    T sum = a(i, 0) * b[0];
    for (int k = 1; k < a.columns(); ++k) sum += a(i, k) * b[static_cast<std::size_t>(k)];
    result.push_back(sum);
  }
  return result;
}

}  // namespace blossom
