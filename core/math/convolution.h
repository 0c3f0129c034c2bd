// SPDX-License-Identifier: LGPL-2.1-or-later
// Products of polynomials by their coefficients: the inner loop of products, powers and
// compositions of forms.

#pragma once

#include <cassert>
#include <cstddef>
#include <span>

namespace blossom {

/// sum[k] += sum_r f[k - r] g[r], for f.size() + g.size() - 1 coefficients, over any scalar.
/// At most min(f.size(), g.size()) roundings each, and one more for the sum.
template <class Scalar>
void add_product(std::span<const Scalar> f, std::span<const Scalar> g, std::span<Scalar> sum) {
  assert(sum.size() + 1 >= f.size() + g.size());
  for (std::size_t k = 0; k + 1 < f.size() + g.size(); ++k) {
    const std::size_t first = k < f.size() ? 0 : k - f.size() + 1;
    Scalar row = f[k - first] * g[first];
    for (std::size_t r = first + 1; r < g.size() && r <= k; ++r) row += f[k - r] * g[r];
    sum[k] += row;
  }
}

/// The same in vectors of doubles.
void add_product(std::span<const double> f, std::span<const double> g, std::span<double> sum);

}  // namespace blossom
