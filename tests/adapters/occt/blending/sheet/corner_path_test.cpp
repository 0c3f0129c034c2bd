// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/sheet/corner_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <gp.hxx>

namespace blossom::occt {
namespace {

TEST(CornerPath, BetweenTwoLikeContactsTurnsAsACircleDoes) {
  const Handle(Geom_Plane) plane = new Geom_Plane(gp::XOY());
  // Contacts along x = 0 and y = 0 that meet in the origin.
  const PathEnd from{{0, 2}, {0, -1}, 2}, to{{2, 0}, {-1, 0}, 2};
  const auto path = corner_path(plane, from, to);
  for (int i = 0; i <= 8; ++i) {
    const gp_Pnt2d p = path->Value(i / 8.0);
    EXPECT_NEAR(std::hypot(p.X() - 2, p.Y() - 2), 2, 6e-4) << i;
  }
  gp_Pnt2d start;
  gp_Vec2d way;
  path->D1(0, start, way);
  EXPECT_NEAR(way.X(), 0, 1e-15);
  EXPECT_LT(way.Y(), 0);
}

// Contacts that end before they meet, one much nearer than the other: the path keeps between their
// tangents and the chord all the same.
TEST(CornerPath, StaysWithinTheTangentsOfContactsThatEnd) {
  const Handle(Geom_Plane) plane = new Geom_Plane(gp::XOY());
  const PathEnd from{{0, 5}, {0, -1}, 0}, to{{0.5, 0}, {-1, 0}, 0};
  const auto path = corner_path(plane, from, to);
  for (int i = 1; i < 8; ++i) {
    const gp_Pnt2d p = path->Value(i / 8.0);
    EXPECT_GT(p.X(), 0) << i;
    EXPECT_GT(p.Y(), 0) << i;
    EXPECT_LT(p.X() / 0.5 + p.Y() / 5, 1) << i;
  }
}

TEST(CornerPath, GoesTheShortWayAcrossASeam) {
  const Handle(Geom_CylindricalSurface) cylinder = new Geom_CylindricalSurface(gp::XOY(), 1);
  const PathEnd from{{0.1, 0}}, to{{2 * std::numbers::pi - 0.1, 1}};
  const auto path = corner_path(cylinder, from, to);
  EXPECT_NEAR(path->Value(0).X(), 0.1, 1e-15);
  EXPECT_NEAR(path->Value(1).X(), -0.1, 1e-12);
  EXPECT_NEAR(path->Value(1).Y(), 1, 1e-15);
}

TEST(CornerPath, LeavesAContactSmoothlyOnItsWayToAnEdge) {
  const Handle(Geom_Plane) plane = new Geom_Plane(gp::XOY());
  const PathEnd contact{{0, 2}, {0, -1}, 1.5}, foot{{1, 0.2}};
  const auto path = corner_path(plane, contact, foot);
  gp_Pnt2d start;
  gp_Vec2d way;
  path->D1(0, start, way);
  EXPECT_NEAR(way.X(), 0, 1e-15);
  EXPECT_LT(way.Y(), 0);
  EXPECT_NEAR(path->Value(1).Distance(gp_Pnt2d(1, 0.2)), 0, 1e-15);
}

}  // namespace
}  // namespace blossom::occt
