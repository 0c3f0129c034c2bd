// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/distance/proven_crossing.h"

#include <gtest/gtest.h>

namespace blossom {
namespace {

// origin + u along + v across.
RationalBezierPatch parallelogram(const Vec3& origin, const Vec3& along, const Vec3& across) {
  RationalBezierPatch patch{Grid<Vec4>(2, 2)};
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      const Vec3 p = origin + double(i) * along + double(j) * across;
      patch.points(i, j) = {p[0], p[1], p[2], 1};
    }
  return patch;
}

const RationalBezierPatch kFloor = parallelogram({0, 0, 0}, {1, 0, 0}, {0, 1, 0});

// z = (u - 1/2)^2 over the unit square.
RationalBezierPatch trough() {
  RationalBezierPatch patch{Grid<Vec4>(3, 2)};
  const double heights[] = {0.25, -0.25, 0.25};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 2; ++j) patch.points(i, j) = {0.5 * i, double(j), heights[i], 1};
  return patch;
}

bool everywhere(const Box4&) { return true; }

TEST(ProvenCrossing, IsFoundWherePlanesCross) {
  const auto wall = parallelogram({0.3, 0, -0.4}, {0, 1, 0}, {0, 0, 1});
  EXPECT_TRUE(proven_crossing(kFloor, wall, {0.3, 0.5, 0.5, 0.4}, everywhere));
  EXPECT_TRUE(proven_crossing(kFloor, wall, {0.31, 0.48, 0.52, 0.37}, everywhere));
  EXPECT_TRUE(proven_crossing(wall, kFloor, {0.5, 0.4, 0.3, 0.5}, everywhere));
}

TEST(ProvenCrossing, IsLookedForInsideFromAPointOnABorder) {
  const auto wall = parallelogram({0.3, 0, -0.4}, {0, 1, 0}, {0, 0, 1});
  EXPECT_TRUE(proven_crossing(kFloor, wall, {0.3, 0, 0, 0.4}, everywhere));
  const auto only_far = [](const Box4& box) { return box[1].from > 0.2; };
  EXPECT_TRUE(proven_crossing(kFloor, wall, {0.3, 0, 0, 0.4}, only_far));
}

TEST(ProvenCrossing, IsNoneWhereTheBoxesDoNotCount) {
  const auto wall = parallelogram({0.3, 0, -0.4}, {0, 1, 0}, {0, 0, 1});
  EXPECT_FALSE(
      proven_crossing(kFloor, wall, {0.3, 0.5, 0.5, 0.4}, [](const Box4&) { return false; }));
}

TEST(ProvenCrossing, IsNoneOfSurfacesThatTouchOrOnlyMeetInBorders) {
  EXPECT_FALSE(proven_crossing(kFloor, trough(), {0.5, 0.5, 0.5, 0.5}, everywhere));
  EXPECT_FALSE(proven_crossing(kFloor, kFloor, {0.5, 0.5, 0.5, 0.5}, everywhere));
  const auto above = parallelogram({0, 0, 1e-9}, {1, 0, 0}, {0, 1, 0});
  EXPECT_FALSE(proven_crossing(kFloor, above, {0.5, 0.5, 0.5, 0.5}, everywhere));
  // The wall stands on the floor: every common point is on its border.
  const auto standing = parallelogram({0.3, 0, 0}, {0, 1, 0}, {0, 0, 1});
  EXPECT_FALSE(proven_crossing(kFloor, standing, {0.3, 0.5, 0.5, 0}, everywhere));
}

}  // namespace
}  // namespace blossom
