// SPDX-License-Identifier: LGPL-2.1-or-later
// Curves that meet themselves.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "core/curve_intersection.h"
#include "tests/support/curves.h"

namespace blossom {
namespace {

using testing::bezier;
using testing::circle;
using testing::in_space;

using std::numbers::pi;

TEST(CurveSelfIntersection, LoopsWithinOneSpanAreFound) {
  const CurveSpans loop = bezier({{0, 0, 0}, {3, 2, 0}, {-2, 2, 0}, {1, 0, 0}});
  for (const bool space : {false, true}) {
    const CurveIntersection found = self_intersections(space ? in_space(loop) : loop);
    EXPECT_EQ(found.status, Status::Complete);
    ASSERT_EQ(found.points.size(), 1U);
    EXPECT_NEAR(found.points[0].a, 0.5 - std::sqrt(0.1875), 1e-13);
    EXPECT_NEAR(found.points[0].b, 0.5 + std::sqrt(0.1875), 1e-13);
  }
}

TEST(CurveSelfIntersection, SimpleAndClosedCurvesHaveNone) {
  for (const CurveSpans& curve :
       {circle({0, 0}, 1), in_space(circle({0.2, 0}, 1)),
        bezier({{-1, 1, 0}, {0, -1, 0}, {1, 1, 0}}), bezier({{-1, 0, 0}, {1, 0, 0}}),
        testing::polygon({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}})}) {
    const CurveIntersection found = self_intersections(curve);
    EXPECT_EQ(found.status, Status::Complete);
    EXPECT_TRUE(found.points.empty());
  }
}

TEST(CurveSelfIntersection, PentagramHasFivePoints) {
  std::vector<Vec3> corners;
  for (int i = 0; i <= 5; ++i)
    corners.push_back({std::cos(0.8 * pi * (i % 5)), std::sin(0.8 * pi * (i % 5)), 0});
  const CurveIntersection found = self_intersections(testing::polygon(corners));
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_EQ(found.points.size(), 5U);
  for (const CurvePoint& p : found.points) EXPECT_LT(p.a, p.b);
}

TEST(CurveSelfIntersection, CuspIsAPlace) {
  const CurveSpans cusp = bezier({{1, -1, 0}, {-1. / 3, 1, 0}, {-1. / 3, -1, 0}, {1, 1, 0}});
  const CurveIntersection found = self_intersections(cusp);
  EXPECT_EQ(found.status, Status::Tolerance);
  EXPECT_TRUE(found.points.empty());
  ASSERT_EQ(found.places.size(), 1U);
  EXPECT_EQ(found.places[0].kind, PlaceKind::Cusp);
  EXPECT_LE(found.places[0].a.from, 0.5);
  EXPECT_GE(found.places[0].b.to, 0.5);
}

// A loop so tight that its far end stays within tolerance of itself is a place, not a second point.
TEST(CurveSelfIntersection, TightLoopHasOnePointAndAtMostACusp) {
  for (const double width : {1e-3, 1e-5, 1e-7, 1e-9}) {
    const double x = (1 + width) / 3;
    const CurveIntersection found =
        self_intersections(bezier({{1, -1, 0}, {-x, 1, 0}, {-x, -1, 0}, {1, 1, 0}}));
    for (const CurvePoint& p : found.points) EXPECT_LT(p.a + 1e-9, p.b) << width;
    EXPECT_LE(found.points.size(), 1U) << width;
    EXPECT_GE(found.points.size() + found.places.size(), 1U) << width;
  }
}

}  // namespace
}  // namespace blossom
