// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces that stand for others within an error.
#include <gtest/gtest.h>

#include "core/base/tolerances.h"
#include "core/surface_intersection.h"
#include "tests/support/solids.h"

namespace blossom {
namespace {

// Whatever they stand for is apart, as places nearer than the tolerance would be listed.
TEST(ApproximatedSurfaces, ThatAreApartAreProvenNotToMeet) {
  const double tolerance = Tolerances{}.point;
  BezierSurface below = testing::quadrilateral({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0.2});
  const BezierSurface above = testing::quadrilateral({0, 0, 3 * tolerance}, {0, 1, 0.1},
                                                     {1, 0, 0.1}, {1, 1, 0.2 + 3 * tolerance});
  below.error = 0.9 * tolerance;
  EXPECT_EQ(intersect(below, above).status, Status::Complete);
  below.error = 1.1 * tolerance;
  EXPECT_EQ(intersect(below, above).status, Status::Tolerance);
}

TEST(ApproximatedSurfaces, HaveAnIntersectionNoBetterThanTheyAre) {
  BezierSurface flat = testing::quadrilateral({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0});
  flat.error = 0.1 * Tolerances{}.point;
  const BezierSurface steep =
      testing::quadrilateral({0.5, 0, -1}, {0.5, 1, -1}, {0.5, 0, 1}, {0.5, 1, 1});
  const SurfaceIntersection found = intersect(flat, steep);
  EXPECT_EQ(found.curves.size(), 1U);
  EXPECT_EQ(found.status, Status::Tolerance);
}

}  // namespace
}  // namespace blossom
