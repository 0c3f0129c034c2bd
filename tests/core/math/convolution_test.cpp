// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/math/convolution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <vector>

#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::Random;
using testing::seeded;
using testing::uniform;

// Whole numbers, so that both ways are exact.
std::vector<double> whole_numbers(Random& random, std::size_t count) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(std::round(uniform(random, -9, 9)));
  return values;
}

TEST(AddProduct, AgreesWithTheSumForAllLengths) {
  Random random = seeded(1);
  for (const std::size_t f : {1u, 2u, 6u, 8u, 9u, 31u, 64u, 65u, 130u})
    for (const std::size_t g : {1u, 3u, 8u, 17u, 61u}) {
      const std::vector<double> a = whole_numbers(random, f), b = whole_numbers(random, g);
      std::vector<double> sum = whole_numbers(random, f + g - 1);
      std::vector<long> expected(sum.begin(), sum.end());
      for (std::size_t i = 0; i < f; ++i)
        for (std::size_t j = 0; j < g; ++j)
          expected[i + j] += static_cast<long>(a[i]) * static_cast<long>(b[j]);
      add_product(std::span(a), std::span(b), std::span(sum));
      EXPECT_EQ(std::vector<long>(sum.begin(), sum.end()), expected) << f << " x " << g;
    }
}

TEST(AddProduct, IsTheSameOverOtherScalars) {
  const std::vector<float> f{1, 2, 3}, g{4, 5};
  std::vector<float> sum{100, 0, 0, 0};
  add_product(std::span(f), std::span(g), std::span(sum));
  EXPECT_EQ(sum, (std::vector<float>{104, 13, 22, 15}));
}

}  // namespace
}  // namespace blossom
