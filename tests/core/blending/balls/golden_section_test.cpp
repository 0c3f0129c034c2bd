// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/balls/detail/golden_section.h"

#include <cmath>

#include <gtest/gtest.h>

namespace blossom {
namespace {

TEST(GoldenSection, FindsWhereAFunctionIsExtremeToAPartOfTheRange) {
  int calls = 0;
  const auto valley = [&](double x) {
    ++calls;
    return std::cosh(x - 0.3);
  };
  EXPECT_NEAR(extremum(valley, {-1, 2}, 1, 1e-5), 0.3, 3e-5);
  EXPECT_LE(calls, 27);  // log(1e5) / log(1.618) and two
  const auto hill = [](double x) { return -std::abs(x - 1.75); };
  EXPECT_NEAR(extremum(hill, {1, 2}, -1, 1e-12), 1.75, 1e-12);
}

TEST(GoldenSection, GoesToTheEndWhereAFunctionIsMonotone) {
  const auto rising = [](double x) { return x; };
  EXPECT_NEAR(extremum(rising, {3, 5}, 1, 1e-9), 3, 4e-9);
  EXPECT_NEAR(extremum(rising, {3, 5}, -1, 1e-9), 5, 4e-9);
}

// Parameters that are hardly told apart do not keep it from ending.
TEST(GoldenSection, EndsInARangeOfAFewRoundings) {
  const double from = 1e6, to = from + 4e-10;
  const double found = extremum([](double x) { return x; }, {from, to}, 1, 1e-12);
  EXPECT_GE(found, from);
  EXPECT_LE(found, to);
}

}  // namespace
}  // namespace blossom
