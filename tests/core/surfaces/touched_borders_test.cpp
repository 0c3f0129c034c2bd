// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces that reach each other in a point of a border only.

#include <gtest/gtest.h>

#include "core/surface_intersection.h"
#include "tests/support/cubic_family.h"

namespace blossom {
namespace {

TEST(TouchedBorders, AreNotProvenToMissTheOtherSurface) {
  // The surfaces meet at y = -(x - p)^2: a ends at y = 0, which that curve touches from outside.
  for (const double p : {0.3, 0.375, 0.5, 0.875}) {
    SCOPED_TRACE(p);
    const testing::Cubic x = testing::linear(-p, 1, 0), y = testing::linear(0, 0, 1);
    const BezierSurface a = testing::graph(0.5 * (y + x * x), {0, 0}, {1, 0}, {0, 1});
    const BezierSurface b = testing::graph({}, {-0.3, -0.3}, {1.7, 0}, {0, 1.7});

    const SurfaceIntersection found = intersect(a, b);

    EXPECT_EQ(found.status, Status::Tolerance);
    EXPECT_TRUE(found.curves.empty());
    ASSERT_EQ(found.points.size(), 1u);
    EXPECT_LE(distance(found.points[0].point, {p, 0, 0}), 1e-5);
  }
}

}  // namespace
}  // namespace blossom
