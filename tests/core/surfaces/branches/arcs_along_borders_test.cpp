// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/branches/arcs_along_borders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/surface_intersection.h"
#include "tests/support/solids.h"

namespace blossom {
namespace {

// Flat patches on both sides of y = 0; the upper one is a hundred thousand times narrower.
BezierSurface two_strips() {
  constexpr double kNarrow = 1e-5;
  BezierSurface strips = testing::quadrilateral({0, -1, 0}, {1, -1, 0}, {0, 0, 0}, {1, 0, 0});
  const BezierSurface upper =
      testing::quadrilateral({0, 0, 0}, {1, 0, 0}, {0, kNarrow, 0}, {1, kNarrow, 0});
  Grid<RationalBezierPatch> both(2, 1);
  both(0, 0) = strips.patches(0, 0);
  both(1, 0) = upper.patches(0, 0);
  strips.patches = both;
  strips.u_knots = {0, 1, 2};
  return strips;
}

class ArcsAlongBorders : public ::testing::TestWithParam<double> {};

// One patch has the line beside its border by rounding of its parameters, the other one has it
// outside by far more of its own.
TEST_P(ArcsAlongBorders, AreFoundOnceWhereverTheLineLies) {
  const BezierSurface strips = two_strips();
  const double y = GetParam();
  const BezierSurface wall = testing::quadrilateral({-1, y, -1}, {2, y, -1}, {-1, y, 1}, {2, y, 1});
  for (const bool turned : {false, true}) {
    const SurfaceIntersection found = turned ? intersect(wall, strips) : intersect(strips, wall);
    ASSERT_EQ(found.curves.size(), 1u) << turned;
    EXPECT_NEAR(found.curves[0].length, 1, 1e-9);
    EXPECT_NE(found.status, Status::Stopped);
  }
}

INSTANTIATE_TEST_SUITE_P(Offsets, ArcsAlongBorders,
                         ::testing::Values(-1e-8, -1e-10, -1e-11, -1e-12, -3e-13, -1e-13, -1e-14,
                                           -1e-16, 0.0, 1e-18, 1e-16, 1e-15, 1e-14, 1e-13, 1e-12,
                                           1e-9));

// A quarter of a cylinder and a plane that is turned by a little about a point of its border: the
// curve is on the cylinder where the plane has passed it.
class CurvesAcrossBorders : public ::testing::TestWithParam<double> {};

TEST_P(CurvesAcrossBorders, AreFoundHoweverSlowlyTheyCross) {
  constexpr double kHeight = 3, kCrossing = 1.4;
  const double tilt = GetParam();
  BezierSurface quarter;
  quarter.u_knots = quarter.v_knots = {0, 1};
  quarter.rational = true;
  quarter.patches = Grid<RationalBezierPatch>(1, 1);
  Grid<Vec4>& net = quarter.patches(0, 0).points;
  net = Grid<Vec4>(3, 2);
  const double w = std::sqrt(0.5);
  for (int j = 0; j < 2; ++j) {
    const double z = j * kHeight;
    net(0, j) = {1, 0, z, 1};
    net(1, j) = {w, w, z * w, w};
    net(2, j) = {0, 1, z, 1};
  }
  const auto corner = [&](double x, double z) { return Vec3{x, tilt * (z - kCrossing), z}; };
  const BezierSurface plane =
      testing::quadrilateral(corner(-1, -1), corner(2, -1), corner(-1, 4), corner(2, 4));
  for (const bool turned : {false, true}) {
    const SurfaceIntersection found =
        turned ? intersect(plane, quarter) : intersect(quarter, plane);
    EXPECT_NE(found.status, Status::Stopped) << turned;
    ASSERT_EQ(found.curves.size(), 1u) << turned;
    EXPECT_LT(found.certificate.certified + found.certificate.critical, 1000) << turned;
    // Within tolerance of the border either side is right.
    const double open = std::min(1e-7 / tilt, kHeight);
    EXPECT_GT(found.curves[0].length, kHeight - kCrossing - open - 1e-7) << turned;
    EXPECT_LT(found.curves[0].length, kHeight - kCrossing + open + 1e-7) << turned;
  }
}

INSTANTIATE_TEST_SUITE_P(Tilts, CurvesAcrossBorders,
                         ::testing::Values(1e-16, 1e-15, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9,
                                           1e-8, 3e-8, 1e-7, 3e-7, 1e-6, 1e-5, 1e-4));

// Cells of a patch are halved at 0.4865 first, off their middle.
TEST(ArcsAlongLines, BetweenCellsOfOnePatchAreFoundOnce) {
  BezierSurface bowl;
  bowl.u_knots = bowl.v_knots = {0, 1};
  bowl.patches = Grid<RationalBezierPatch>(1, 1);
  Grid<Vec4>& net = bowl.patches(0, 0).points;
  net = Grid<Vec4>(4, 4);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const double x = i / 3.0, y = j / 3.0;
      net(i, j) = {x, y, 2 * ((x - 0.5) * (x - 0.5) + (y - 0.5) * (y - 0.5)), 1};
    }
  for (const double x : {0.4865, 0.47, 0.5, 0.4865 * 0.4865}) {
    const BezierSurface wall =
        testing::quadrilateral({x, -1, -1}, {x, 2, -1}, {x, -1, 2}, {x, 2, 2});
    for (const bool turned : {false, true}) {
      const SurfaceIntersection found = turned ? intersect(wall, bowl) : intersect(bowl, wall);
      EXPECT_EQ(found.curves.size(), 1u) << x << ' ' << turned;
      EXPECT_NE(found.status, Status::Stopped) << x << ' ' << turned;
    }
  }
}

}  // namespace
}  // namespace blossom
