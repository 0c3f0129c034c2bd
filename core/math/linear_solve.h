// SPDX-License-Identifier: LGPL-2.1-or-later
// Systems of a few linear equations, without allocation.

#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "core/math/vec.h"

namespace blossom {

/// A square matrix by rows.
template <int N>
using SquareMatrix = std::array<Vec<double, N>, static_cast<std::size_t>(N)>;

/// Solves m x = b in place of b, by elimination with the largest pivot of each column.
/// returns   false if a pivot is 0 or not a number
/// Source: Golub and Van Loan 2013, Matrix Computations, 3.4.
template <int N>
bool solve(SquareMatrix<N> m, Vec<double, N>& b) {
  constexpr auto kSize = static_cast<std::size_t>(N);
  for (std::size_t k = 0; k < kSize; ++k) {
    const int column = static_cast<int>(k);
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < kSize; ++i)
      if (std::abs(m[i][column]) > std::abs(m[pivot][column])) pivot = i;
    if (!(std::abs(m[pivot][column]) > 0)) return false;
    std::swap(m[k], m[pivot]);
    std::swap(b.coordinates[k], b.coordinates[pivot]);
    for (std::size_t i = k + 1; i < kSize; ++i) {
      const double factor = m[i][column] / m[k][column];
      for (int j = column + 1; j < N; ++j) m[i][j] -= factor * m[k][j];
      b.coordinates[i] -= factor * b.coordinates[k];
    }
  }
  for (int i = N - 1; i >= 0; --i) {
    const Vec<double, N>& row = m[static_cast<std::size_t>(i)];
    for (int j = i + 1; j < N; ++j) b[i] -= row[j] * b[j];
    b[i] /= row[i];
  }
  return true;
}

/// The x with x[0] c0 + x[1] c1 + x[2] c2 = r, by Cramer's rule; nothing if these columns are
/// dependent.
inline std::optional<Vec3> solved(const Vec3& c0, const Vec3& c1, const Vec3& c2, const Vec3& r) {
  const Vec3 n = cross(c1, c2);
  const double d = dot(c0, n);
  if (d == 0 || !std::isfinite(1 / d)) return std::nullopt;
  return Vec3{dot(r, n) / d, dot(c0, cross(r, c2)) / d, dot(c0, cross(c1, r)) / d};
}

}  // namespace blossom
