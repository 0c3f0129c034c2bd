// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/adjacency/corner_separation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace blossom {
namespace {

// A sector around the origin, with a side in it: over angles about one direction, rising by a
// slope.
CellTree sector(double direction, double half_angle, double slope, const Vec3& tip = {}) {
  RationalBezierPatch patch{Grid<Vec4>(2, 2)};
  for (const int j : {0, 1}) {
    const double angle = direction + (j == 0 ? -half_angle : half_angle);
    patch.points(0, j) = {tip[0], tip[1], tip[2], 1};
    patch.points(1, j) = {2 * std::cos(angle), 2 * std::sin(angle), 2 * slope, 1};
  }
  return CellTree(patch, false, {}, CellForm::Bezier, 0.5);
}

bool are_separated(const CellTree& a, const CellTree& b, double reach) {
  return separated_at({}, a[0], b[0], a.shape().plane_size(), b.shape().plane_size(), reach);
}

TEST(CornerSeparation, TellsSectorsOnEitherSideApart) {
  EXPECT_TRUE(are_separated(sector(0, 1, 0), sector(3.1, 1, 0.2), 1e-7));
  EXPECT_TRUE(are_separated(sector(0, 0.5, 0), sector(1.2, 0.5, 0), 1e-7));
}

TEST(CornerSeparation, ClaimsNothingOfSectorsThatMeetInALine) {
  EXPECT_FALSE(are_separated(sector(0, 0.5, 0), sector(0.8, 0.5, 0), 1e-7));
  EXPECT_FALSE(are_separated(sector(0, 0.5, 0), sector(1, 0.5, 0), 1e-7));
}

// A tip that is off by e makes what both have in common longer than e, by the angle between them.
TEST(CornerSeparation, KeepsWithinItsReach) {
  const CellTree a = sector(0, 0.5, 0), b = sector(1.2, 0.5, 0, {1e-9, 0, 0});
  EXPECT_TRUE(are_separated(a, b, 1e-6));
  EXPECT_FALSE(are_separated(a, b, 2e-9));
}

TEST(CornerSeparation, ClaimsNothingOfAnotherPoint) {
  const CellTree a = sector(0, 1, 0), b = sector(3.1, 1, 0);
  EXPECT_FALSE(separated_at({0, 0, 1}, a[0], b[0], 4, 4, 1e-7));
}

}  // namespace
}  // namespace blossom
