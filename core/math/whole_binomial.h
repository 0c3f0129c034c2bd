// SPDX-License-Identifier: LGPL-2.1-or-later
// Binomial coefficients as whole numbers, as far as 64 bits hold them all.

#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>

namespace blossom {

/// Highest upper index whose coefficients all fit 64 bits.
inline constexpr int kMaxWholeBinomial = 67;

namespace detail {
inline constexpr auto kWholeBinomials = [] {
  std::array<std::array<std::uint64_t, kMaxWholeBinomial + 1>, kMaxWholeBinomial + 1> table{};
  for (std::size_t n = 0; n < table.size(); ++n) {
    table[n][0] = 1;
    for (std::size_t k = 1; k <= n; ++k) table[n][k] = table[n - 1][k - 1] + table[n - 1][k];
  }
  return table;
}();
}  // namespace detail

/// n! / (k! (n - k)!), exact; 0 for k < 0 or k > n.
///
/// n        0..kMaxWholeBinomial
constexpr std::uint64_t whole_binomial(int n, int k) {
  assert(0 <= n && n <= kMaxWholeBinomial);
  if (k < 0 || k > n) return 0;
  return detail::kWholeBinomials[static_cast<std::size_t>(n)][static_cast<std::size_t>(k)];
}

}  // namespace blossom
