// SPDX-License-Identifier: LGPL-2.1-or-later
// Fillets over what is in their way: holes and notches of faces, and narrow faces that go on
// smoothly, which the ball consumes.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <gp_Ax2.hxx>

#include "adapters/occt/blending/continuity.h"
#include "adapters/occt/edge_facts.h"
#include "adapters/occt/fillet.h"
#include "tests/adapters/occt/fillet_checks.h"

namespace blossom::occt {
namespace {

// One sound solid, smooth wherever it is nearly so.
void expect_smooth_solid(const FilletResult& made) {
  testing::expect_sound(made);
  if (made.solids.size() != 1) return;
  for (const EdgeContinuity& edge : edge_continuity(made.solids.front().solid))
    if (edge.found && edge.found->angle.value < 0.05) {
      EXPECT_LT(edge.found->angle.value, 1e-6) << "radians, along edge " << edge.number;
    }
}

int edge_with_middle(const TopoDS_Shape& shape, const Vec3& point) {
  for (const EdgeFacts& each : edge_facts(shape))
    if (distance(each.middle, point) < 1e-6) return each.number;
  return 0;
}

constexpr double kPi = std::numbers::pi;

TopoDS_Shape block() { return BRepPrimAPI_MakeBox(20, 10, 10).Shape(); }

// What a ball of radius r that rolls along y = 0, z = 10 leaves of a hole of a radius round
// (10, y): of the cylinder's volume over the strip, by Simpson's rule across it.
double cut_in_hole(double r, double hole, double y) {
  const int steps = 20000;
  const double from = std::max(0.0, y - hole), to = std::min(r, y + hole);
  // y = from + (to - from) sin^2 is smooth at both ends of the hole and of the arc.
  double sum = 0;
  for (int i = 0; i <= steps; ++i) {
    const double a = 0.5 * kPi * i / steps;
    const double x = from + (to - from) * std::sin(a) * std::sin(a);
    const double wide = 2 * std::sqrt(std::max(0.0, hole * hole - (x - y) * (x - y)));
    const double deep = r - std::sqrt(std::max(0.0, r * r - (r - x) * (r - x)));
    const double rate = (to - from) * std::sin(2 * a);
    sum += wide * deep * rate * (i == 0 || i == steps ? 1 : i % 2 == 1 ? 4 : 2);
  }
  return sum * 0.5 * kPi / steps / 3;
}

TEST(FilletOverAHole, IsCutByTheHolesWall) {
  struct Case {
    double radius, y;
  };
  // Across the middle of the hole, its near and its far part.
  for (const Case& each : {Case{2, 2}, Case{2, 2.5}, Case{3, 2.4}, Case{3, 2.15}}) {
    const double hole = 1;
    const TopoDS_Shape shape =
        BRepAlgoAPI_Cut(block(),
                        BRepPrimAPI_MakeCylinder(gp_Ax2({10, each.y, -1}, {0, 0, 1}), hole, 12))
            .Shape();
    const FilletResult made =
        fillet(shape, {edge_with_middle(shape, {10, 0, 10})}, {.radius = each.radius});
    expect_smooth_solid(made);
    if (made.solids.empty()) continue;
    const double removed =
        (1 - kPi / 4) * each.radius * each.radius * 20 - cut_in_hole(each.radius, hole, each.y);
    EXPECT_NEAR(made.volume_before - made.solids.front().volume, removed, 1e-6);
  }
}

// The strip would have a hole of its own, which is not built.
TEST(FilletOverAHole, IsRefusedWhereTheContactPassesIt) {
  const TopoDS_Shape shape =
      BRepAlgoAPI_Cut(block(), BRepPrimAPI_MakeCylinder(gp_Ax2({10, 1.5, -1}, {0, 0, 1}), 1, 12))
          .Shape();
  const FilletResult made = fillet(shape, {edge_with_middle(shape, {10, 0, 10})}, {.radius = 3});
  EXPECT_TRUE(made.solids.empty());
  ASSERT_EQ(made.refused.size(), 1U);
}

// The wall goes on down to the strip, which would leave the boss in the air.
TEST(FilletUnderABoss, IsMetByTheBosssWall) {
  const double radius = 3, y = 3.5;
  const TopoDS_Shape shape =
      BRepAlgoAPI_Fuse(block(), BRepPrimAPI_MakeCylinder(gp_Ax2({10, y, 9}, {0, 0, 1}), 1, 5))
          .Shape();
  const FilletResult made =
      fillet(shape, {edge_with_middle(shape, {10, 0, 10})}, {.radius = radius});
  expect_smooth_solid(made);
  ASSERT_EQ(made.solids.size(), 1U);
  const double removed = (1 - kPi / 4) * radius * radius * 20 - cut_in_hole(radius, 1, y);
  EXPECT_NEAR(made.volume_before - made.solids.front().volume, removed, 1e-6);
}

// A drilled lug beside a round housing: the rim's contact goes under the housing's wall, which
// grows down to the strip, with the seam where that happens or elsewhere.
TEST(FilletUnderABoss, IsMetByAWallWhereverItsSeamIs) {
  std::vector<double> changes;
  for (const double turn : {0.0, 1.0}) {
    const gp_Pnt middle(18 * std::cos(turn), 18 * std::sin(turn), 0);
    const gp_Ax2 there(middle, {0, 0, 1});
    const TopoDS_Shape housing = BRepPrimAPI_MakeCylinder(15, 20).Shape();
    const TopoDS_Shape lug = BRepPrimAPI_MakeCylinder(there, 5, 8).Shape();
    const TopoDS_Shape drill = BRepPrimAPI_MakeCylinder(there, 2, 8).Shape();
    const TopoDS_Shape shape = BRepAlgoAPI_Cut(BRepAlgoAPI_Fuse(housing, lug).Shape(), drill);
    int rim = 0;
    for (const EdgeFacts& each : edge_facts(shape))
      if (std::abs(each.middle[2] - 8) < 1e-9 &&
          std::abs(std::hypot(each.middle[0] - middle.X(), each.middle[1] - middle.Y()) - 2) < 1e-9)
        rim = each.number;
    ASSERT_GT(rim, 0);
    const FilletResult made = fillet(shape, {rim}, {.radius = 1.5});
    testing::expect_sound(made);
    ASSERT_FALSE(made.solids.empty());
    changes.push_back(made.solids.front().volume - made.volume_before);
  }
  EXPECT_LT(changes[0], 0);
  EXPECT_NEAR(changes[0], changes[1], 1e-6);
}

TEST(FilletOverANotch, IsCutByAllOfItsWalls) {
  // Ends at y = 1.5, inside of the strip of radius 2, and y = 4, beyond it.
  const TopoDS_Shape shape =
      BRepAlgoAPI_Cut(block(), BRepPrimAPI_MakeBox(gp_Pnt(8, 1.5, 5), gp_Pnt(12, 4, 11)).Shape())
          .Shape();
  const FilletResult made = fillet(shape, {edge_with_middle(shape, {10, 0, 10})}, {.radius = 2});
  expect_smooth_solid(made);
  // Over the notch the ball takes the area below its arc from y = 1.5 to 2 less.
  const double c = 0.5, area = 2 * c - (0.5 * c * std::sqrt(4 - c * c) + 2 * std::asin(0.5 * c));
  const double removed = (1 - kPi / 4) * 4 * 20 - 4 * area;
  EXPECT_NEAR(made.volume_before - made.solids.front().volume, removed, 1e-7);
}

// An outline of lines and an arc, upright: the top z = 0 from x = 0 to 10, its right side goes down
// from there by `depth`, and turns inwards along a quarter of a circle of radius 4.
TopoDS_Shape undercut(double depth, double length) {
  const std::array<gp_Pnt, 6> at{gp_Pnt(0, 0, 0),           gp_Pnt(10, 0, 0),
                                 gp_Pnt(10, 0, -depth),     gp_Pnt(6, 0, -depth - 4),
                                 gp_Pnt(6, 0, -depth - 10), gp_Pnt(0, 0, -depth - 10)};
  const double turn = 4 * std::sqrt(0.5);
  BRepBuilderAPI_MakeWire wire;
  for (std::size_t i = 0; i < 6; ++i) {
    if (i != 2) {
      wire.Add(BRepBuilderAPI_MakeEdge(at[i], at[(i + 1) % 6]));
      continue;
    }
    const gp_Pnt middle(6 + turn, 0, -depth - turn);
    wire.Add(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(at[2], middle, at[3]).Value()));
  }
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire.Wire()).Face(), gp_Vec(0, length, 0))
      .Shape();
}

// The ball touches the top and the round part below the narrow upright face.
TEST(FilletThatConsumesASmoothFace, IsOnTheFaceBehindIt) {
  const double depth = 0.5, r = 2;
  const TopoDS_Shape shape = undercut(depth, 7);
  const FilletResult made = fillet(shape, {edge_with_middle(shape, {10, 3.5, 0})}, {.radius = r});
  expect_smooth_solid(made);
  ASSERT_EQ(made.solids.size(), 1U);
  // Inside of the round part's circle round (6, -depth), at the distance 4 - r, and r below the
  // top.
  const double sink = r - depth, x = 6 + std::sqrt((4 - r) * (4 - r) - sink * sink);
  // What is above the circle's middle, and below it up to the contact, less the ball's sector.
  const double angle = std::atan2(sink, x - 6);
  const double above = (10 - x) * depth, below = 0.5 * 16 * angle - 0.5 * (x - 6) * sink;
  const double sector = 0.5 * r * r * (0.5 * kPi + angle);
  EXPECT_NEAR(made.volume_before - made.solids.front().volume, 7 * (above + below - sector), 1e-6);
  int kept = 0;
  for (const FilletFace& face : made.solids.front().faces) kept += face.from > 0 ? 1 : 0;
  EXPECT_EQ(kept, 7) << "the narrow face is gone";
}

}  // namespace
}  // namespace blossom::occt
