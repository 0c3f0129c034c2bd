// SPDX-License-Identifier: LGPL-2.1-or-later
// Scaled Bernstein coefficients, over any scalar: c_k binom(d, k) for the coefficient c_k.
//
// In them the product of two forms is the plain product of polynomials, which is what makes
// products, powers and compositions cheap. Source: Farouki and Rajan 1988.

#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/math/convolution.h"
#include "core/math/detail/bernstein.h"
#include "core/math/detail/scalar.h"
#include "core/math/grid.h"
#include "core/math/whole_binomial.h"

namespace blossom::detail {

/// binom(n, k) as a scalar: exact where the scalar is, rounded once in double (never for n <= 56).
template <class Scalar>
Scalar binomial_as(int n, int k) {
  const std::uint64_t whole = whole_binomial(n, k);
  if (whole >> 53 == 0) return Scalar(static_cast<double>(whole));
  const Scalar high(static_cast<double>(whole >> 32));
  const Scalar low(static_cast<double>(whole & 0xffffffffu));
  return high * Scalar(0x1p32) + low;
}

/// c_k binom(d, k), k = 0..d: at most 2 roundings each, 1 for d <= 56.
template <class T>
std::vector<T> scaled(std::span<const T> coefficients) {
  const int d = static_cast<int>(coefficients.size()) - 1;
  std::vector<T> result(coefficients.begin(), coefficients.end());
  for (int k = 1; k < d; ++k) result[index(k)] *= binomial_as<scalar_of<T>>(d, k);
  return result;
}

/// The way back: at most 3 roundings each.
template <class T>
std::vector<T> unscaled(std::vector<T> coefficients) {
  using Scalar = scalar_of<T>;
  const int d = static_cast<int>(coefficients.size()) - 1;
  for (int k = 1; k < d; ++k) coefficients[index(k)] *= Scalar(1) / binomial_as<Scalar>(d, k);
  return coefficients;
}

/// Row i: a^(n - i) b^i for i = 0..n, with a and b of degree d: (n + 1) x (n d + 1).
/// Each of the n factors carries its own roundings, each of n - 1 products d + 1 more.
template <class Scalar>
Grid<Scalar> mixed_powers(std::span<const Scalar> a, std::span<const Scalar> b, int n) {
  const int d = static_cast<int>(a.size()) - 1;
  Grid<Scalar> result(n + 1, n * d + 1, Scalar(0));
  if (n == 0) {
    result(0, 0) = Scalar(1);
    return result;
  }
  std::copy(a.begin(), a.end(), row_of(result, 0).begin());
  std::copy(b.begin(), b.end(), row_of(result, 1).begin());
  std::vector<Scalar> before(index(n * d + 1));
  for (int power = 1; power < n; ++power) {
    const std::size_t length = index(power * d + 1);
    // The last row times b is a new one; all rows times a take their own place.
    for (int i = power + 1; i >= 0; --i) {
      std::copy_n(row_of(result, std::min(i, power)).begin(), length, before.begin());
      const std::span<Scalar> row = row_of(result, i);
      std::fill(row.begin(), row.end(), Scalar(0));
      add_product(std::span<const Scalar>(before).first(length), i > power ? b : a, row);
    }
  }
  return result;
}

}  // namespace blossom::detail
