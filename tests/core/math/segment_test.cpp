// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/math/segment.h"

#include <gtest/gtest.h>

namespace blossom {
namespace {

TEST(Segment, IsNearestInItsInnerOrInAnEnd) {
  const Vec2 from{1, 1}, to{5, 1};
  EXPECT_EQ(nearest_part(Vec2{2, 4}, from, to), 0.25);
  EXPECT_EQ(segment_gap(Vec2{2, 4}, from, to), 3);
  EXPECT_EQ(nearest_part(Vec2{-2, 5}, from, to), 0);
  EXPECT_EQ(segment_gap(Vec2{-2, 5}, from, to), 5);
  EXPECT_EQ(nearest_part(Vec2{8, -3}, from, to), 1);
  EXPECT_EQ(way_from_segment(Vec2{8, -3}, from, to), (Vec2{3, -4}));
}

TEST(Segment, MayBeAPoint) {
  const Vec3 point{1, 2, 3};
  EXPECT_EQ(nearest_part(Vec3{1, 2, 5}, point, point), 0);
  EXPECT_EQ(segment_gap(Vec3{1, 2, 5}, point, point), 2);
}

}  // namespace
}  // namespace blossom
