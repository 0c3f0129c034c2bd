// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/pair_search/arc_lines.h"

#include <gtest/gtest.h>
#include <Geom_CylindricalSurface.hxx>
#include <gp_Ax3.hxx>

#include <array>
#include <numbers>

#include "adapters/occt/convert/surfaces.h"

namespace blossom::occt {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kPointTolerance = 1e-7;

// A whole cylinder of radius 100, its arcs cut at quarters of the turn, with a contact on it.
bool may_be_of_lines(double angle, double size) {
  const Handle(Geom_CylindricalSurface) shape = new Geom_CylindricalSurface(gp_Ax3(), 100);
  const BezierSurface surface = bezier_surface(shape, {{0, kTurn}, {0, 1}});
  const Vec3 at = point_at(surface, {angle, 0.5});
  const std::array<Interval, 4> parameters{Interval{angle, angle}, Interval{0.5, 0.5},
                                           Interval{angle, angle}, Interval{0.5, 0.5}};
  SurfaceIntersection found;
  found.status = Status::Tolerance;
  found.places.push_back({PlaceKind::Touch, at, at + Vec3{0, 0, size}, 0, 0, parameters});
  return may_be_of_arc_lines(found, surface, surface, kPointTolerance);
}

TEST(ArcLines, HoldDoubtsThatAreNoFartherThanTheyAreLargeOrThanTheTolerance) {
  const double line = kTurn / 4, step = kPointTolerance / 100;
  for (const double side : {-1, 1}) {
    EXPECT_TRUE(may_be_of_lines(line + 0.9 * side * step, 0));
    EXPECT_FALSE(may_be_of_lines(line + 1.1 * side * step, 0));
    EXPECT_TRUE(may_be_of_lines(line + 0.9e-5 * side, 1e-3));
    EXPECT_FALSE(may_be_of_lines(line + 1.1e-5 * side, 1e-3));
  }
}

TEST(ArcLines, AreNotWhereAWholeTurnCloses) {
  EXPECT_FALSE(may_be_of_lines(kTurn, 0));
  EXPECT_FALSE(may_be_of_lines(1e-12, 0));
}

TEST(ArcLines, MayHoldDoubtsWhoseParametersAreNotKnown) {
  const Handle(Geom_CylindricalSurface) shape = new Geom_CylindricalSurface(gp_Ax3(), 100);
  const BezierSurface whole = bezier_surface(shape, {{0, kTurn}, {0, 1}});
  const BezierSurface quarter = bezier_surface(shape, {{0, kTurn / 4}, {0, 1}});
  SurfaceIntersection found;
  found.status = Status::Tolerance;
  found.places.push_back({PlaceKind::Tangential, {}, {}, 0, 0, {}});
  EXPECT_TRUE(may_be_of_arc_lines(found, whole, quarter, kPointTolerance));
  EXPECT_FALSE(may_be_of_arc_lines(found, quarter, quarter, kPointTolerance));
}

}  // namespace
}  // namespace blossom::occt
