// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/cells/direction_cones.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/forms/evaluation.h"
#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::Random;
using testing::seeded;
using testing::uniform;

constexpr Axes kAxes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};

// Some positive multiple of the direction lies in the box.
bool holds_direction(const VectorBounds& bounds, const Vec3& direction) {
  double from = 0, to = 1e300;
  for (int k = 0; k < 3; ++k) {
    const double low = bounds.middle[k] - bounds.radius[k];
    const double high = bounds.middle[k] + bounds.radius[k];
    const double d = direction[k];
    if (d == 0 && (low > 0 || high < 0)) return false;
    if (d == 0) continue;
    from = std::max(from, (d > 0 ? low : high) / d);
    to = std::min(to, (d > 0 ? high : low) / d);
  }
  return from <= to * (1 + 1e-12);
}

// Points in space one apart, weights of 1 to 2.
RationalBezierPatch rational_patch(Random& random) {
  Grid<Vec4> net(4, 4);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const double w = uniform(random, 1, 2);
      net(i, j) = {w * i, w * j, w * uniform(random, 0, 1), w};
    }
  return {net};
}

RationalBezierPatch shaken(RationalBezierPatch patch, double by, Random& random) {
  for (Vec4& p : patch.points.values())
    for (int k = 0; k < 3; ++k) p[k] += p[3] * (uniform(random, 0, 1) < 0.5 ? -by : by);
  return patch;
}

TEST(DirectionCones, HoldTheDerivativesOfWhateverWasRoundedToThePatch) {
  Random random = seeded(1);
  for (int draw = 0; draw < 50; ++draw) {
    const RationalBezierPatch patch = rational_patch(random);
    const double rounding = 0.05;
    const DirectionCones cones =
        cones_of(slope_nets(patch, true, rounding), {0.25, 0.5}, {0.5, 0.75}, kAxes);
    for (int k = 0; k < 20; ++k) {
      const PatchJet jet = jet_at(shaken(patch, rounding, random), uniform(random, 0.25, 0.5),
                                  uniform(random, 0.5, 0.75), 1);
      EXPECT_TRUE(holds_direction(cones.u, jet.u)) << draw;
      EXPECT_TRUE(holds_direction(cones.v, jet.v)) << draw;
    }
  }
}

// Triangles of one tip at right angles.
TEST(DirectionCones, PartsAtAPoleAreNoFartherApartThanTheirRounding) {
  const auto triangle = [](double turn) {
    Grid<Vec4> net(2, 2);
    for (int j = 0; j < 2; ++j) {
      const double angle = turn + 0.5 * j;
      net(0, j) = {0, 0, 0, 1};
      net(1, j) = {std::cos(angle), std::sin(angle), 0, 1};
    }
    return RationalBezierPatch{net};
  };
  const auto apart = [&](double rounding) {
    const SlopeNets a = slope_nets(triangle(0), true, rounding);
    const SlopeNets b = slope_nets(triangle(1.5), true, rounding);
    return meet_in_pole_only({a, {0, 1}, {0, 1}, PoleSide::LowU},
                             {b, {0, 1}, {0, 1}, PoleSide::LowU}, {});
  };
  EXPECT_TRUE(apart(0));
  EXPECT_TRUE(apart(1e-6));
  EXPECT_FALSE(apart(0.5));
}

}  // namespace
}  // namespace blossom
