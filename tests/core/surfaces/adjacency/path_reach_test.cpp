// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/adjacency/path_reach.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace blossom {
namespace {

VectorBounds exactly(const Vec3& x) { return {x, {}}; }

const std::array kAlongX{Vec3{1, 0, 0}};

// One face leads to the edge along y; the other one away from it at this angle to the first.
double reach_at(double angle) {
  const std::array across{exactly({0, 1, 0}), exactly({0, std::cos(angle), std::sin(angle)})};
  return path_reach(across, kAlongX);
}

TEST(PathReach, IsOneWhereFacesGoOnSmoothly) { EXPECT_NEAR(reach_at(0), 1, 2e-5); }

TEST(PathReach, IsThatOfTheBisectorAcrossACrease) {
  for (const double angle : {0.5, 1.0, std::numbers::pi / 2, 2.5})
    EXPECT_NEAR(reach_at(angle), 1 / std::cos(angle / 2), 2e-5) << angle;
}

TEST(PathReach, IsInfiniteWhereAFaceFoldsBackOnTheOther) {
  EXPECT_EQ(reach_at(std::numbers::pi), std::numeric_limits<double>::infinity());
}

TEST(PathReach, DoesNotGrowWithStepsThatAreAskewToTheEdge) {
  const std::array across{exactly({1, 1, 0}), exactly({-1, 1, 0})};
  EXPECT_NEAR(path_reach(across, kAlongX), 1, 2e-5);
}

TEST(PathReach, IsInfiniteWhereAStepMayRunAlongTheEdge) {
  const std::array across{VectorBounds{{0, 1, 0}, {0, 1, 0}}, exactly({0, 1, 0})};
  EXPECT_EQ(path_reach(across, kAlongX), std::numeric_limits<double>::infinity());
}

// All that steps of these directions leave of a closed path is as short as promised.
TEST(PathReach, BoundsTheStepsOfAPathThatIsClosedButForAJump) {
  const std::array across{VectorBounds{{0, 1, 0.2}, {0.1, 0.1, 0.1}},
                          VectorBounds{{0.1, 1, 0.9}, {0.1, 0.1, 0.1}}};
  const std::array along{Vec3{1, 0.05, 0}, Vec3{1, -0.05, 0.02}};
  const double reach = path_reach(across, along);
  ASSERT_LT(reach, 3);
  for (int i = 0; i < 4096; ++i) {
    const auto sign = [&](int bit) { return (i >> bit & 1) != 0 ? 1.0 : -1.0; };
    const auto corner = [&](const VectorBounds& b, int bit) {
      return b.middle + Vec3{sign(bit) * b.radius[0], sign(bit + 1) * b.radius[1],
                             sign(bit + 2) * b.radius[2]};
    };
    const Vec3 to = corner(across[0], 0), from = corner(across[1], 3);
    const Vec3 step = (i >> 6 & 1) != 0 ? along[0] : along[1];
    const double s = (i >> 7 & 3) / 3.0, back = -((i >> 9 & 7) - 3.0);
    const Vec3 jump = to * s + from * (1 - s) + step * back;
    // The first end is `to * s` from the edge, seen along it.
    const Vec3 ahead = unit(step);
    const Vec3 seen = to * s - ahead * dot(ahead, to * s);
    EXPECT_LE(norm(seen), reach * norm(jump) * (1 + 1e-9));
  }
}

TEST(PathReach, IsInfiniteWhereTheEdgeTurnsTooFar) {
  const std::array across{exactly({0, 1, 0}), exactly({0, 1, 0})};
  const std::array along{Vec3{1, 1, 0}, Vec3{1, -1, 0}};
  EXPECT_EQ(path_reach(across, along), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace blossom
