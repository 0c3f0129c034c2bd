// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/cells/known_curves.h"

#include <gtest/gtest.h>

#include "core/surface_intersection.h"
#include "tests/support/solids.h"

namespace blossom {
namespace {

// From (0, 0, 0) over (1, 0, 0) to (1, 1, 0), with radius 0.1.
KnownCurve corner() { return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, 0.1, 0}; }

TEST(KnownCurves, HoldBoxesWithinTheRadius) {
  const KnownCurves known({corner()}, {});
  EXPECT_TRUE(known.hold({{0.4, -0.05, -0.05}, {0.5, 0.05, 0.05}}));
  EXPECT_FALSE(known.hold({{0.4, -0.05, -0.05}, {0.5, 0.05, 0.15}}));
  EXPECT_FALSE(KnownCurves({}, {}).hold({{0, 0, 0}, {0, 0, 0}}));
}

TEST(KnownCurves, HoldLongThinBoxesAlongLinks) {
  EXPECT_TRUE(KnownCurves({corner()}, {}).hold({{0, -0.01, 0}, {1, 0.01, 0}}));
  // Over several links of one line: no link alone holds it.
  const KnownCurve line{{{0, 0, 0}, {0.3, 0, 0}, {0.6, 0, 0}, {1, 0, 0}}, 0.1, 0};
  EXPECT_TRUE(KnownCurves({line}, {}).hold({{0, -0.01, 0}, {1, 0.01, 0}}));
  EXPECT_FALSE(KnownCurves({line}, {}).hold({{0, -0.01, 0}, {1.2, 0.01, 0}}));
}

TEST(KnownCurves, DoNotHoldWhatLiesBetweenTheirLinks) {
  // All corners of the square are near the two links, its middle is not.
  EXPECT_FALSE(KnownCurves({corner()}, {}).hold({{0, 0, 0}, {1, 1, 0}}));
}

TEST(KnownCurves, AreTakenRelativeToTheOrigin) {
  const KnownCurves known({corner()}, {5, 0, 0});
  EXPECT_TRUE(known.hold({{-4.6, 0, 0}, {-4.5, 0.01, 0}}));
  EXPECT_FALSE(known.hold({{0.4, 0, 0}, {0.5, 0.01, 0}}));
}

TEST(KnownCurves, HoldWhatTwoBoxesHaveInCommon) {
  const KnownCurves known({corner()}, {});
  EXPECT_TRUE(known.hold_common({{0, -1, -1}, {1, 0, 1}}, {{0, 0, -0.01}, {1, 1, 0.01}}));
  EXPECT_FALSE(known.hold_common({{0, -1, -1}, {1, 0.5, 1}}, {{0, 0, -0.01}, {1, 1, 0.01}}));
}

// z = x (1 - x) + bend y^2 over [0, 1] x [0, side].
BezierSurface sheet(double side, double bend) {
  RationalBezierPatch patch{Grid<Vec4>(3, 3)};
  const double x[] = {0, 0.5, 1}, height[] = {0, 0.5, 0};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      patch.points(i, j) = {x[i], 0.5 * side * j, height[i] + (j == 2 ? bend * side * side : 0), 1};
  return testing::one_patch(patch);
}

// Sheets that go on smoothly across y = 0, where rounding lets them touch, miss and cross.
TEST(KnownCurves, TakeInTheWholeBorderOfSheetsThatGoOnSmoothly) {
  const BezierSurface a = sheet(1, 0.3), b = sheet(-1, -0.7);
  IntersectionOptions options;
  KnownCurve border{{}, 4e-3, 0};
  for (int i = 0; i <= 48; ++i) border.points.push_back({i / 48.0, 0, i / 48.0 * (1 - i / 48.0)});
  options.known = {border};
  const SurfaceIntersection found = intersect(a, b, options);
  EXPECT_EQ(found.status, Status::Tolerance);
  EXPECT_TRUE(found.curves.empty());
  EXPECT_EQ(found.places.size(), 1U);
}

}  // namespace
}  // namespace blossom
