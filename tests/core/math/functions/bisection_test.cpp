// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/math/functions/bisection.h"

#include <gtest/gtest.h>

#include <numbers>

namespace blossom {
namespace {

TEST(Bisected, ClosesInOnTheEndOfAStatementAsOftenAsSaid) {
  const auto is_before = [](double t) { return t * t < 2; };
  const Interval found = bisected({0, 2}, 40, is_before);
  EXPECT_TRUE(is_before(found.from));
  EXPECT_FALSE(is_before(found.to));
  EXPECT_EQ(length(found), 0x1p-39);
  EXPECT_NEAR(found.to, std::numbers::sqrt2, 0x1p-39);
}

TEST(Bisected, RunsBackwardsToo) {
  const Interval found = bisected({2, 0}, 3, [](double t) { return t > 0.9; });
  EXPECT_EQ(found, (Interval{1, 0.75}));
}

}  // namespace
}  // namespace blossom
