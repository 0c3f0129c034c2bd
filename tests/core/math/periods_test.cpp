// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/math/periods.h"

#include <gtest/gtest.h>

namespace blossom {
namespace {

TEST(Unwrapped, IsNearestByWholePeriods) {
  EXPECT_EQ(unwrapped(0.5, 10.25, 4), 8.5);
  EXPECT_EQ(unwrapped(0.5, -9, 4), -7.5);
  EXPECT_EQ(unwrapped(0.5, 10.25, 0), 0.5);
  EXPECT_EQ(unwrapped(Vec2{0.5, 0.5}, Vec2{10.25, 10.25}, Vec2{4, 0}), (Vec2{8.5, 0.5}));
}

}  // namespace
}  // namespace blossom
