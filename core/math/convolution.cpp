// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/math/convolution.h"

#include <algorithm>
#include <cstring>

#include "core/math/four.h"

namespace blossom {
namespace {

constexpr int kBlock = 8;  // coefficients of the product made at a time
constexpr int kChunk = 64;

[[gnu::always_inline]] inline void load(const double* p, Four& low, Four& high) {
  std::memcpy(&low, p, sizeof low);
  std::memcpy(&high, p + 4, sizeof high);
}

// The product of at most kChunk coefficients of f, between zeros in `padded`, and all of g.
[[gnu::always_inline]] inline void add_chunk(const double* padded, int length, const double* g,
                                             int count, double* sum) {
  const int last = length + count - 1;
  for (int k = 0; k < last; k += kBlock) {
    Four low{}, high{}, next_low, next_high;
    for (int r = std::max(0, k - length + 1); r <= std::min(count - 1, k + kBlock - 1); ++r) {
      load(padded + kBlock + k - r, next_low, next_high);
      low += g[r] * next_low;
      high += g[r] * next_high;
    }
    if (k + kBlock <= last) {
      load(sum + k, next_low, next_high);
      low += next_low;
      high += next_high;
      std::memcpy(sum + k, &low, sizeof low);
      std::memcpy(sum + k + 4, &high, sizeof high);
    } else {
      for (int i = k; i < last; ++i) sum[i] += i - k < 4 ? low[i - k] : high[i - k - 4];
    }
  }
}

BLOSSOM_HOT void add_chunks(const double* f, int length, const double* g, int count, double* sum) {
  double padded[kChunk + 2 * kBlock] = {};
  for (int first = 0; first < length; first += kChunk) {
    const int chunk = std::min(kChunk, length - first);
    std::memcpy(padded + kBlock, f + first, static_cast<std::size_t>(chunk) * sizeof *f);
    std::fill_n(padded + kBlock + chunk, kBlock, 0.0);
    add_chunk(padded, chunk, g, count, sum + first);
  }
}

}  // namespace

void add_product(std::span<const double> f, std::span<const double> g, std::span<double> sum) {
  assert(sum.size() + 1 >= f.size() + g.size());
  add_chunks(f.data(), static_cast<int>(f.size()), g.data(), static_cast<int>(g.size()),
             sum.data());
}

}  // namespace blossom
