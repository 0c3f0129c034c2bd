// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/math/interval.h"

#include <gtest/gtest.h>

namespace blossom {
namespace {

TEST(Interval, IsIncreasingFromItsLeastParameter) {
  EXPECT_EQ(increasing({3, 1}), (Interval{1, 3}));
  EXPECT_EQ(increasing({1, 3}), (Interval{1, 3}));
}

TEST(Interval, OverlapsInAnEndToo) {
  EXPECT_TRUE(overlap({0, 1}, {1, 2}));
  EXPECT_FALSE(overlap({0, 1}, {1.5, 2}));
  EXPECT_EQ(hull({0, 1}, {1.5, 2}), (Interval{0, 2}));
}

TEST(Interval, IsWithinItself) {
  EXPECT_TRUE(within({0, 1}, {0, 1}));
  EXPECT_FALSE(within({0, 1.5}, {0, 1}));
}

}  // namespace
}  // namespace blossom
