// SPDX-License-Identifier: LGPL-2.1-or-later
// Random small loops: none is lost, and each is proven.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "core/surface_intersection.h"
#include "tests/support/components.h"
#include "tests/support/cubic_family.h"
#include "tests/support/intersection_checks.h"
#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::Components;
using testing::components;
using testing::Cubic;
using testing::CubicPair;
using testing::uniform;

// Radii from 1e-3 to 0.1, each decade as often; the loop is scale r^2 deep, 10 tolerances or more.
TEST(SmallLoops, AreNeverLost) {
  for (int seed = 0; seed < 1000; ++seed) {
    testing::Random random = testing::seeded(seed);
    const double a = uniform(random, 0.15, 0.85), b = uniform(random, 0.15, 0.85);
    const double r = seed % 3 == 0 ? 1e-3 : std::pow(10, uniform(random, -3, -1));
    const double scale = seed % 2 == 0 ? 1 : 8;
    const testing::CubicPair pair = cubic_pair(testing::loop(a, b, r, scale));

    const SurfaceIntersection found = intersect(pair.a, pair.b);

    SCOPED_TRACE(::testing::Message() << seed << ": a " << a << " b " << b << " r " << r);
    EXPECT_EQ(found.status, Status::Complete);
    EXPECT_EQ(components(found), (Components{.closed = 1}));
    EXPECT_TRUE(found.places.empty());
    const double length = 2 * std::numbers::pi * r;
    EXPECT_NEAR(testing::total_projected_length(found), length, 1e-6 * length);
  }
}

// Less deep than the tolerance, a loop may be read as a touch in one order of the surfaces: the
// other one, or a finer tolerance, tells it.
TEST(SmallLoops, LessDeepThanTheToleranceAreLoopsInBothOrders) {
  struct LoopDraw {
    double a, b, depth, r;
  };
  for (const LoopDraw& draw : std::vector<LoopDraw>{{0.693, 0.542, 8.8e-8, 0.0162},
                                                    {0.489, 0.792, 1.13e-7, 0.0195},
                                                    {0.416, 0.691, 7.27e-9, 0.0034},
                                                    {0.266, 0.691, 1.5e-8, 0.0112},
                                                    {0.698, 0.219, 2.5e-8, 0.0133},
                                                    {0.5, 0.5, 3e-8, 0.01}}) {
    SCOPED_TRACE(draw.depth);
    const double scale = draw.depth / (draw.r * draw.r);
    const testing::CubicPair pair = cubic_pair(testing::loop(draw.a, draw.b, draw.r, scale));
    for (const auto& found : {intersect(pair.a, pair.b), intersect(pair.b, pair.a)}) {
      EXPECT_LE(found.status, Status::Tolerance);
      EXPECT_EQ(components(found), (Components{.closed = 1}));
      const double length = 2 * std::numbers::pi * draw.r;
      EXPECT_NEAR(testing::total_projected_length(found), length, 1e-4 * length);
    }
  }
}

// A parabolic cylinder above a plane, whose bends are known without error: nearer than the
// tolerance all along a line is a contact, however sure it is that the surfaces do not meet.
TEST(SmallLoops, ALineWithinToleranceStaysAContact) {
  for (const double gap : {0.0, 1e-13, 1e-10, 5e-8}) {
    const Cubic across = testing::linear(-0.6, 1, 0.2);
    const CubicPair pair =
        cubic_pair(across * across + testing::constant(gap), testing::constant(0));

    const SurfaceIntersection found = intersect(pair.a, pair.b);

    EXPECT_EQ(found.status, Status::Tolerance) << gap;
    ASSERT_EQ(found.curves.size(), 1u) << gap;
    EXPECT_TRUE(found.curves[0].tangential) << gap;
  }
}

}  // namespace
}  // namespace blossom
