// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/intersection/contact_chains.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/surface_intersection.h"
#include "tests/core/tracing/surface_pairs.h"
#include "tests/support/surface_changes.h"

namespace blossom {
namespace {

// About the axis z.
BezierSurface turned(const BezierSurface& surface, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  testing::Motion turn;
  turn.rotation = {Vec3{c, -s, 0}, Vec3{s, c, 0}, Vec3{0, 0, 1}};
  return moved(surface, turn);
}

// A torus touches the cylinder round it along its outer equator. Each surface's parameters jump at
// its seam, so the circle is cut there: its images stay on the surfaces.
TEST(ContactChains, EndWhereTheSeamOfASurfaceIs) {
  const double pi = std::numbers::pi;
  const BezierSurface a = testing::revolved(testing::circle(1, 0.4, -1, 2 * pi - 1, 4),
                                            {-1, pi / 2 - 1, pi - 1, 1.5 * pi - 1, 2 * pi - 1},
                                            ParameterLaw::Angle, 2 * pi, 4);
  const BezierSurface b = turned(testing::cylinder(1.4, -1, 1), 1);

  const SurfaceIntersection found = intersect(a, b);

  EXPECT_EQ(found.status, Status::Tolerance);
  ASSERT_FALSE(found.curves.empty());
  double length = 0;
  for (const IntersectionCurve& curve : found.curves) {
    EXPECT_TRUE(curve.tangential);
    EXPECT_FALSE(curve.closed);
    EXPECT_LE(std::max({curve.deviation.a, curve.deviation.b, curve.deviation.between}), 1e-6);
    length += curve.length;
  }
  EXPECT_NEAR(length, 2 * pi * 1.4, 1e-6);
}

}  // namespace
}  // namespace blossom
