// SPDX-License-Identifier: LGPL-2.1-or-later
// Binomial coefficients up to degree 50, exact in double.

#pragma once

#include <array>
#include <cassert>

namespace blossom {

/// Highest upper index of `binomial`: the sum of two highest degrees, for triangles cut out of
/// tensor-product patches. binom(50, 25) is below 2^47.
inline constexpr int kMaxBinomial = 50;

namespace detail {
inline constexpr auto kBinomials = [] {
  std::array<std::array<double, kMaxBinomial + 1>, kMaxBinomial + 1> table{};
  for (std::size_t n = 0; n < table.size(); ++n) {
    table[n][0] = 1;
    for (std::size_t k = 1; k <= n; ++k) table[n][k] = table[n - 1][k - 1] + table[n - 1][k];
  }
  return table;
}();
}  // namespace detail

/// n! / (k! (n - k)!), exact; 0 for k < 0 or k > n.
///
/// n        0..kMaxBinomial
constexpr double binomial(int n, int k) {
  assert(0 <= n && n <= kMaxBinomial);
  if (k < 0 || k > n) return 0;
  return detail::kBinomials[static_cast<std::size_t>(n)][static_cast<std::size_t>(k)];
}

/// N! / (i! j! (N - i - j)!) = binom(N, i) binom(N - i, j); exact below 2^53, that is N <= 36.
constexpr double trinomial(int n, int i, int j) { return binomial(n, i) * binomial(n - i, j); }

}  // namespace blossom
