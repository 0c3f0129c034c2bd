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

TEST(TouchedBorders, HoldCurvesThatRunAlongThemInACorner) {
  // y = k x^2 touches the border y = 0 of a in the corner where it begins.
  for (const double k : {0.2, 1.0, 5.0})
    for (const Vec2 corner : {Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}, Vec2{1, 1}}) {
      SCOPED_TRACE(::testing::Message() << k << " in " << corner[0] << ", " << corner[1]);
      const testing::Cubic x =
          corner[0] == 0 ? testing::linear(0, 1, 0) : testing::linear(1, -1, 0);
      const testing::Cubic y =
          corner[1] == 0 ? testing::linear(0, 0, 1) : testing::linear(1, 0, -1);
      const BezierSurface a = testing::graph(0.5 * (y + -k * (x * x)), {0, 0}, {1, 0}, {0, 1});
      const BezierSurface b = testing::graph({}, {-0.3, -0.3}, {1.7, 0}, {0, 1.7});

      const SurfaceIntersection found = intersect(a, b);

      EXPECT_EQ(found.status, Status::Complete);
      EXPECT_TRUE(found.points.empty());
      EXPECT_TRUE(found.places.empty());
      ASSERT_EQ(found.curves.size(), 1u);
      const auto& samples = found.curves[0].samples;
      const Vec3 place{corner[0], corner[1], 0};
      EXPECT_LE(
          std::min(distance(samples.front().point, place), distance(samples.back().point, place)),
          1e-9);
    }
}

TEST(TouchedBorders, HoldNoCurvesThatLeaveThemInACorner) {
  const testing::Cubic x = testing::linear(0, 1, 0), y = testing::linear(0, 0, 1);
  const BezierSurface a = testing::graph(0.5 * (y + x * x), {0, 0}, {1, 0}, {0, 1});
  const BezierSurface b = testing::graph({}, {-0.3, -0.3}, {1.7, 0}, {0, 1.7});

  const SurfaceIntersection found = intersect(a, b);

  EXPECT_TRUE(found.curves.empty());
  ASSERT_EQ(found.points.size(), 1u);
  EXPECT_LE(norm(found.points[0].point), 1e-9);
}

// A strip ends in the other surface along a border that is shorter than a touch would be.
TEST(TouchedBorders, AreCurvesFromCornerToCornerHoweverShort) {
  for (const double height : {1e-2, 1e-4, 1e-5, 1e-6, 5e-7}) {
    SCOPED_TRACE(height);
    BezierSurface strip = testing::graph({}, {0, 0}, {2, 0}, {0, height});
    for (Vec4& p : strip.patches(0, 0).points.values()) p = {p[0], 0.5 * p[0], p[1], 1};
    BezierSurface wall = testing::graph({}, {-3, -3}, {6, 0}, {0, 6});
    for (Vec4& p : wall.patches(0, 0).points.values()) p = {0, p[0], p[1], 1};

    const SurfaceIntersection found = intersect(wall, strip);

    EXPECT_EQ(found.status, Status::Complete);
    EXPECT_TRUE(found.points.empty());
    ASSERT_EQ(found.curves.size(), 1u);
    EXPECT_NEAR(found.curves[0].length, height, 1e-13);
  }
}

}  // namespace
}  // namespace blossom
