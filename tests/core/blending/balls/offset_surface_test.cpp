// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/balls/offset_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/errors.h"
#include "core/blending/balls/chart_cell.h"
#include "tests/support/ball_shapes.h"

namespace blossom {
namespace {

using testing::floor_face;
using testing::upper_sphere;
using testing::whole_cylinder;

ChartRectangle all_of(const BezierSurface& s) { return whole_support(s, 1).part; }

// Largest value of |off| over a fine grid of own parameters.
template <class Off>
double worst_off(const BezierSurface& s, const Off& off) {
  double worst = 0;
  for (int i = 0; i <= 60; ++i)
    for (int j = 0; j <= 60; ++j) {
      const Vec2 uv{at({s.u_knots.front(), s.u_knots.back()}, i / 60.0),
                    at({s.v_knots.front(), s.v_knots.back()}, j / 60.0)};
      worst = std::max(worst, std::abs(off(uv, point_at(s, uv))));
    }
  return worst;
}

TEST(OffsetSurface, OfAPlaneIsAPlane) {
  const BezierSurface plane = testing::plane_patch({0, 0, 1}, {1, 0, 0}, {0.3, 1, 0});
  const OffsetSurface offset = offset_surface(plane, all_of(plane), -0.25, 1e-9);
  EXPECT_LT(offset.error, 1e-14);
  EXPECT_EQ(offset.surface.patches.values().size(), 1U);
  EXPECT_LT(worst_off(offset.surface, [](const Vec2&, const Vec3& p) { return p[2] - 0.75; }),
            1e-14);
}

TEST(OffsetSurface, OfACylinderKeepsItsAngles) {
  const BezierSurface cylinder = whole_cylinder(2, 3);
  const OffsetSurface offset = offset_surface(cylinder, all_of(cylinder), 0.5, 1e-10);
  EXPECT_TRUE(offset.surface.closed_u);
  EXPECT_EQ(offset.surface.patches.columns(), 1);  // v is straight
  const auto off = [](const Vec2& uv, const Vec3& p) {
    return distance(p, Vec3{2.5 * std::cos(uv[0]), 2.5 * std::sin(uv[0]), uv[1]});
  };
  EXPECT_LT(worst_off(offset.surface, off), 1e-10);
  EXPECT_LT(offset.error, 1e-10);
}

TEST(OffsetSurface, OfAPartOverASeamIsCutThere) {
  const BezierSurface cylinder = whole_cylinder(2, 3);
  const OffsetSurface offset = offset_surface(cylinder, {{5.5, 7.5}, {0, 1}}, 0.5, 1e-10);
  EXPECT_FALSE(offset.surface.closed_u);
  EXPECT_EQ(offset.surface.u_knots.front(), 5.5);
  EXPECT_EQ(std::count(offset.surface.u_knots.begin(), offset.surface.u_knots.end(),
                       cylinder.u_knots.back()),
            1);
  const auto off = [](const Vec2& uv, const Vec3& p) {
    return distance(p, Vec3{2.5 * std::cos(uv[0]), 2.5 * std::sin(uv[0]), uv[1]});
  };
  EXPECT_LT(worst_off(offset.surface, off), 1e-10);
}

TEST(OffsetSurface, GoesOverAPole) {
  const BezierSurface sphere = upper_sphere(2);
  const OffsetSurface offset = offset_surface(sphere, all_of(sphere), -0.5, 1e-9);
  EXPECT_LT(worst_off(offset.surface, [](const Vec2&, const Vec3& p) { return norm(p) - 1.5; }),
            1e-9);
}

TEST(OffsetSurface, IsWithinItsStatedErrors) {
  const BezierSurface floor = floor_face();
  for (const double tolerance : {1e-5, 1e-7, 1e-9}) {
    const ChartRectangle part{{0.1, 0.7}, {0.3, 1}};
    const OffsetSurface offset = offset_surface(floor, part, 0.3, tolerance);
    EXPECT_LE(offset.error, tolerance);
    EXPECT_EQ(offset.surface.error, offset.error);
    EXPECT_EQ(offset.surface.u_knots.front(), 0.1);
    EXPECT_EQ(offset.surface.u_knots.back(), 0.7);
    const auto off = [&](const Vec2& uv, const Vec3& p) {
      const PatchJet s = chart_jet(floor, cell_at(floor, uv), uv, 1);
      return distance(p, s.point + 0.3 * unit(cross(s.u, s.v)));
    };
    EXPECT_LT(worst_off(offset.surface, off), offset.error + 1e-15);
  }
}

TEST(OffsetSurface, FoldsWithoutHarm) {
  const BezierSurface trough = testing::trough(2, 0.5, 1);
  const OffsetSurface offset = offset_surface(trough, all_of(trough), 0.4, 1e-9);
  const auto off = [](const Vec2& uv, const Vec3& p) {
    const double x = 2 * uv[0] * 0.5 - 0.5, slope = 4 * x, n = std::hypot(1, slope);
    return distance(p, Vec3{x - 0.4 * slope / n, uv[1], 2 * x * x + 0.4 / n});
  };
  EXPECT_LT(worst_off(offset.surface, off), 1e-9);
}

TEST(OffsetSurface, RefusesCreasesAndEmptyParts) {
  BezierSurface creased = testing::plane_patch({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const BezierSurface up = testing::plane_patch({1, 0, 0}, {0, 0, 1}, {0, 1, 0});
  const RationalBezierPatch first = creased.patches(0, 0);
  creased.u_knots = {0, 1, 2};
  creased.patches = Grid<RationalBezierPatch>(2, 1, first);
  creased.patches(1, 0) = up.patches(0, 0);
  EXPECT_THROW(offset_surface(creased, all_of(creased), 0.1, 1e-9), InvalidInput);
  const BezierSurface floor = floor_face();
  EXPECT_THROW(offset_surface(floor, {{0.5, 0.5}, {0, 1}}, 0.1, 1e-9), InvalidInput);
  EXPECT_THROW(offset_surface(floor, all_of(floor), 0.1, 0), InvalidInput);
  EXPECT_THROW(offset_surface(floor, all_of(floor), 1.0 / 0.0, 1e-9), InvalidInput);
}

}  // namespace
}  // namespace blossom
