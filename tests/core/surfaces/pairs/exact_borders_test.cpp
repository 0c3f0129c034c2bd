// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/pairs/exact_borders.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "core/surface_intersection.h"
#include "tests/support/solids.h"

namespace blossom {
namespace {

constexpr double kTiny = 0x1p-60;

// Biquadratic patches over x in [0, 4], y in [0, 2] and [-2, 0], of heights in whole numbers; the
// control points of the line y = 0 between them are at z = `line`.
BezierSurface two_patches(const std::array<double, 3>& line) {
  BezierSurface surface;
  surface.u_knots = {0, 1};
  surface.v_knots = {-1, 0, 1};
  surface.patches = Grid<RationalBezierPatch>(1, 2);
  for (int half = 0; half < 2; ++half) {
    Grid<Vec4> net(3, 3);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const int row = 2 * half + j;  // 0..4, 2 on the line
        const std::array<double, 5> above{-3.0 - i, -1, 0, 1, 2.0 + i};
        const double z = line[static_cast<std::size_t>(i)];
        net(i, j) = {2.0 * i, row - 2.0, z + above[static_cast<std::size_t>(row)], 1};
      }
    surface.patches(0, half) = {net};
  }
  return surface;
}

SurfaceIntersection with_floor(const BezierSurface& surface, bool turned, double height = 0) {
  const double z = height;
  const BezierSurface floor =
      testing::quadrilateral({-1, -3, z}, {5, -3, z}, {-1, 3, z}, {5, 3, z});
  return turned ? intersect(floor, surface) : intersect(surface, floor);
}

TEST(ExactBorders, AKnotLineInAPlaneIsProven) {
  for (const bool turned : {false, true}) {
    const SurfaceIntersection found = with_floor(two_patches({0, 0, 0}), turned);
    EXPECT_EQ(found.status, Status::Complete) << turned;
    ASSERT_EQ(found.curves.size(), 1);
    EXPECT_NEAR(found.curves[0].length, 4, 1e-9);
  }
  // A plane that is not parallel to an axis: z = x / 2.
  const BezierSurface ramp =
      testing::quadrilateral({-1, -3, -0.5}, {5, -3, 2.5}, {-1, 3, -0.5}, {5, 3, 2.5});
  EXPECT_EQ(intersect(two_patches({0, 1, 2}), ramp).status, Status::Complete);
}

// The patch of y >= 0 alone: the line is its border.
BezierSurface upper_patch(const std::array<double, 3>& line) {
  BezierSurface surface = two_patches(line);
  surface.v_knots = {0, 1};
  const RationalBezierPatch patch = surface.patches(0, 1);
  surface.patches = Grid<RationalBezierPatch>(1, 1, patch);
  return surface;
}

// By less than any rounding off: no longer that line. With both sides there is one curve, wherever
// it runs; with one of them nobody has proven what there is.
TEST(ExactBorders, ALineOffByLessThanRoundingIsNotClaimed) {
  for (const auto& line : {std::array{kTiny, 0.0, 0.0},
                           {0.0, -kTiny, 0.0},
                           {kTiny, -kTiny, kTiny},
                           {0.0, 0.0, std::numeric_limits<double>::denorm_min()}})
    for (const bool turned : {false, true}) {
      const SurfaceIntersection found = with_floor(two_patches(line), turned);
      EXPECT_EQ(found.status, Status::Complete) << line[0] << ' ' << line[1] << ' ' << turned;
      EXPECT_EQ(found.curves.size(), 1);
      EXPECT_EQ(with_floor(upper_patch(line), turned).status, Status::Tolerance);
    }
  EXPECT_EQ(with_floor(upper_patch({0, 0, 0}), false, kTiny).status, Status::Tolerance);
}

// The same surface of degree 4 in u, by u / (2 - u): all numbers stay short.
BezierSurface other_form(BezierSurface surface) {
  const Grid<Vec4>& p = surface.patches(0, 0).points;
  Grid<Vec4> q(5, 2);
  for (int j = 0; j < 2; ++j) {
    const std::array x{p(0, j), p(1, j), p(2, j)};
    const Vec4 second = (1.0 / 6) * (x[0] + 4 * x[1] + x[2]);
    const std::array raised{x[0], 0.5 * (x[0] + x[1]), second, 0.5 * (x[1] + x[2]), x[2]};
    for (int i = 0; i < 5; ++i)
      q(i, j) = std::ldexp(1.0, 4 - i) * raised[static_cast<std::size_t>(i)];
  }
  surface.rational = true;
  surface.patches(0, 0) = {q};
  return surface;
}

// Two patches that share a bent edge, at an angle all along it.
TEST(ExactBorders, ASharedEdgeIsProvenAndNearlySharedIsNot) {
  const auto wing = [](double up, double middle) {
    BezierSurface surface;
    surface.u_knots = surface.v_knots = {0, 1};
    surface.patches = Grid<RationalBezierPatch>(1, 1);
    Grid<Vec4> net(3, 2);
    for (int i = 0; i < 3; ++i) {
      const double x = i, y = i == 1 ? middle : 0.0;
      net(i, 0) = {x, y, 0, 1};
      net(i, 1) = {x, y + 1, up * (1 + 0.25 * i), 1};
    }
    surface.patches(0, 0) = {net};
    return surface;
  };
  const double same = 0.375, next = std::nextafter(0.375, 1);
  for (const double up : {0.5, -0.75}) {
    const SurfaceIntersection found = intersect(wing(1, same), wing(up, same));
    EXPECT_EQ(found.status, Status::Complete) << up;
    EXPECT_EQ(found.curves.size(), 1);
    EXPECT_EQ(intersect(wing(1, same), other_form(wing(up, same))).status, Status::Complete) << up;
    EXPECT_EQ(intersect(wing(1, same), wing(up, next)).status, Status::Tolerance) << up;
  }
}

}  // namespace
}  // namespace blossom
