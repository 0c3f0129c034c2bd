// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/math/functions/golden_section.h"

#include <algorithm>
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
  EXPECT_NEAR(extremum(valley, {-1, 2}, 1, 1e-5).place, 0.3, 3e-5);
  EXPECT_LE(calls, 27);  // log(1e5) / log(1.618) and two
  const auto hill = [](double x) { return -std::abs(x - 1.75); };
  EXPECT_NEAR(extremum(hill, {1, 2}, -1, 1e-12).place, 1.75, 1e-12);
  EXPECT_NEAR(extremum(hill, {1, 2}, -1, 1e-12).value, 0, 1e-12);
}

TEST(GoldenSection, GoesToTheEndWhereAFunctionIsMonotone) {
  const auto rising = [](double x) { return x; };
  EXPECT_NEAR(extremum(rising, {3, 5}, 1, 1e-9).place, 3, 4e-9);
  EXPECT_NEAR(extremum(rising, {3, 5}, -1, 1e-9).place, 5, 4e-9);
}

// Parameters that are hardly told apart do not keep it from ending.
TEST(GoldenSection, EndsInARangeOfAFewRoundings) {
  const double from = 1e6, to = from + 4e-10;
  const double found = extremum([](double x) { return x; }, {from, to}, 1, 1e-12).place;
  EXPECT_GE(found, from);
  EXPECT_LE(found, to);
}

// The least of all values that were asked for is not lost, however a function goes.
TEST(GoldenSection, KeepsTheLeastValueItHasSeen) {
  double least = 1;
  const auto waves = [&](double x) {
    const double value = std::sin(40 * x) + x * x;
    least = std::min(least, value);
    return value;
  };
  EXPECT_EQ(extremum(waves, {-1, 2}, 1, 1e-6).value, least);
}

TEST(GoldenSection, StopsWhereItIsTold) {
  const LeastBracket found =
      least_bracket([](double x) { return x * x; }, {-1, 2},
                    [](const Interval&, const LeastBracket& b) { return b.value() < 1e-2; });
  EXPECT_LT(std::abs(found.place()), 1e-1);
  EXPECT_GT(length(found.places), 1e-2);
}

}  // namespace
}  // namespace blossom
