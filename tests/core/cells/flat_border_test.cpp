// SPDX-License-Identifier: LGPL-2.1-or-later
// A surface that touches a plane along its border, and is singular in points of it, meets itself no
// more than one that is not.

#include "core/cells/flat_border.h"

#include <gtest/gtest.h>

#include <functional>

#include "core/self_intersection.h"

namespace blossom {
namespace {

// A polynomial of degree 2 in u and v from -1 to 1 and from 0 to 1, by its values at nine points.
BezierSurface quadratic(const std::function<Vec3(double u, double v)>& value) {
  Grid<Vec4> net(3, 3);
  const auto bezier = [](const Vec3& a, const Vec3& middle, const Vec3& b) {
    return 2.0 * middle - 0.5 * (a + b);
  };
  Vec3 points[3][3];
  for (int j = 0; j < 3; ++j) {
    const double v = 0.5 * j;
    points[0][j] = value(-1, v);
    points[2][j] = value(1, v);
    points[1][j] = bezier(points[0][j], value(0, v), points[2][j]);
  }
  for (int i = 0; i < 3; ++i) {
    const Vec3 middle = bezier(points[i][0], points[i][1], points[i][2]);
    const Vec3 row[3] = {points[i][0], middle, points[i][2]};
    for (int j = 0; j < 3; ++j) net(i, j) = {row[j][0], row[j][1], row[j][2], 1};
  }
  BezierSurface surface;
  surface.patches = Grid<RationalBezierPatch>(1, 1);
  surface.patches(0, 0) = {net};
  surface.u_knots = {0, 1};
  surface.v_knots = {0, 1};
  surface.rational = false;
  return surface;
}

// Its border is a parabola in the plane z = 0. At u = 0 lines across leave it along itself; `off`
// is how far it leaves the plane.
BezierSurface lip(double off) {
  return quadratic([=](double u, double v) {
    const double r = 1 - v;
    return Vec3{u + 0.3 * r, 0.1 * u * u + u * r, r * r + off * r * (1 - u)};
  });
}

TEST(FlatBorder, IsFoundWhereASurfaceTouchesAPlaneAlongIt) {
  const BezierSurface surface = lip(0);
  SurfaceCells cells(surface, {}, CellForm::Auto, 0.5);
  EXPECT_TRUE(FlatBorder::of(cells, PoleSide::HighV, 1e-7).has_value());
  EXPECT_FALSE(FlatBorder::of(cells, PoleSide::LowV, 1e-7).has_value());
  EXPECT_FALSE(FlatBorder::of(cells, PoleSide::LowU, 1e-7).has_value());
}

TEST(FlatBorder, IsFlatWithinTheTolerance) {
  const BezierSurface near = lip(1e-8), far = lip(1e-6);
  SurfaceCells cells_near(near, {}, CellForm::Auto, 0.5), cells_far(far, {}, CellForm::Auto, 0.5);
  const auto border = FlatBorder::of(cells_near, PoleSide::HighV, 1e-7);
  ASSERT_TRUE(border.has_value());
  EXPECT_GT(border->within(), 1e-9);
  EXPECT_LE(border->within(), 1e-7);
  EXPECT_FALSE(FlatBorder::of(cells_far, PoleSide::HighV, 1e-7).has_value());
}

TEST(FlatBorder, ProvesThatALipWithASingularPointDoesNotMeetItself) {
  for (const double off : {0.0, 1e-8}) {
    const SurfaceIntersection found = self_intersect(lip(off), {});
    EXPECT_EQ(found.status, Status::Complete) << off;
    EXPECT_TRUE(found.curves.empty() && found.points.empty() && found.places.empty()) << off;
    EXPECT_GE(found.certificate.identified, 1);
    EXPECT_GE(found.certificate.identified_within, 0.1 * off);
    EXPECT_LE(found.certificate.identified_within, 2e-8);
  }
}

// Its halves lie on each other: nothing is to be proven.
TEST(FlatBorder, ProvesNothingOfALipThatIsLaidTogether) {
  IntersectionOptions options;
  options.budget = 10'000;
  const BezierSurface folded = quadratic([](double u, double v) {
    const double r = 1 - v;
    return Vec3{u * u + 0.1 * r, u * u - r, r * r};
  });
  EXPECT_NE(self_intersect(folded, options).status, Status::Complete);
}

}  // namespace
}  // namespace blossom
