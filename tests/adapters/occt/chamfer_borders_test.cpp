// SPDX-License-Identifier: LGPL-2.1-or-later
// Borders of chamfers beside poles, and past the ends of edges at which faces touch.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <gp_Ax2.hxx>

#include "adapters/occt/edge_facts.h"
#include "adapters/occt/fillet.h"
#include "tests/adapters/occt/fillet_checks.h"

namespace blossom::occt {
namespace {

FilletResult chamfered(const TopoDS_Shape& shape, EdgeKind kind, double distance) {
  std::vector<int> edges;
  for (const EdgeFacts& each : edge_facts(shape))
    if (each.kind == kind) edges.push_back(each.number);
  FilletOptions options;
  options.chamfer = ChamferSize{distance};
  return fillet(shape, edges, options);
}

// A ball with a bore beside its centre; its poles are on an axis.
TopoDS_Shape bored_ball(const gp_Dir& poles) {
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(gp_Ax2({0, 0, 0}, poles), 10).Shape();
  const gp_Ax2 bore({4.4, 0, -20}, {0, 0, 1});
  return BRepAlgoAPI_Cut(ball, BRepPrimAPI_MakeCylinder(bore, 4, 40).Shape()).Shape();
}

// Between (-18, -13, 0) and (18, 13, 0), wider by 3 at a height of 12, its slanting edges rounded.
TopoDS_Shape drafted_core() {
  BRepOffsetAPI_ThruSections loft(true, true);
  for (const double z : {0., 12.}) {
    const double x = 18 + z / 4, y = 13 + z / 4;
    BRepBuilderAPI_MakePolygon wire(gp_Pnt(-x, -y, z), gp_Pnt(x, -y, z), gp_Pnt(x, y, z),
                                    gp_Pnt(-x, y, z), true);
    loft.AddWire(wire.Wire());
  }
  const TopoDS_Shape core = loft.Shape();
  std::vector<int> slanting;
  for (const EdgeFacts& each : edge_facts(core))
    if (std::abs(each.middle[2] - 6) < 1e-9) slanting.push_back(each.number);
  return fillet(core, slanting, {.radius = 4}).solids.front().solid;
}

}  // namespace

// The edges pass the poles at 0.4, and their borders on the ball at 0.6 on the other side.
TEST(ChamferBorder, IsTheSameWhereverABallHasItsPoles) {
  const FilletResult beside = chamfered(bored_ball({0, 0, 1}), EdgeKind::Convex, 1);
  testing::expect_sound(beside);
  const FilletResult far = chamfered(bored_ball({0, 1, 0}), EdgeKind::Convex, 1);
  testing::expect_sound(far);
  if (beside.solids.size() == 1 && far.solids.size() == 1) {
    EXPECT_NEAR(beside.solids.front().volume, far.solids.front().volume, 1e-6);
  }
}

// Past the ends of the edges of equal pipes the strips meet at angles down to 0, where rounding
// moves the points in which they cross. What is filled grows with the square of the distance.
TEST(ChamferBorder, OfEqualPipesIsMadeOfAnyDistance) {
  const TopoDS_Shape tee =
      BRepAlgoAPI_Fuse(BRepPrimAPI_MakeCylinder(gp_Ax2({-30, 0, 0}, {1, 0, 0}), 10, 60).Shape(),
                       BRepPrimAPI_MakeCylinder(10, 30).Shape())
          .Shape();
  for (const double distance : {0.9, 0.92, 0.93, 0.95, 1.0, 1.2, 2.0, 3.0}) {
    SCOPED_TRACE(distance);
    const FilletResult made = chamfered(tee, EdgeKind::Concave, distance);
    testing::expect_sound(made);
    if (made.solids.size() != 1) continue;
    const double filled = made.solids.front().volume - made.volume_before;
    EXPECT_NEAR(filled / (distance * distance), 26.3, 0.05 * 26.3);
  }
}

// Borders lie in the planes across the rim, and go over the edges between the walls, which are
// aslant to it: before the rim's own edges end at the one end of the walls, behind them at the
// other. In each plane a triangle is cut off or added.
TEST(ChamferBorder, GoesOverTheSlantingEdgesBetweenWallsWithDraft) {
  const TopoDS_Shape core = drafted_core();
  const TopoDS_Shape pocket =
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(gp_Pnt(-30, -30, -10), gp_Pnt(30, 30, 12)).Shape(), core)
          .Shape();
  for (const TopoDS_Shape& shape : {core, pocket})
    for (const double height : {0., 12.})
      for (const double size : {0.05, 1.}) {
        std::vector<int> rim;
        double sines = 0;
        for (const EdgeFacts& each : edge_facts(shape))
          if (std::abs(each.middle[2] - height) < 1e-9 && std::abs(each.middle[0]) < 25 &&
              std::abs(each.middle[1]) < 25) {
            rim.push_back(each.number);
            sines += std::sin(each.angle) * each.length;
          }
        ASSERT_EQ(rim.size(), 8U);
        FilletOptions options{.largest = false};
        options.chamfer = ChamferSize{size};
        const FilletResult made = fillet(shape, {rim.front()}, options);
        testing::expect_sound(made);
        ASSERT_FALSE(HasFailure()) << height << " " << size;
        const double change = std::abs(made.solids.front().volume - made.volume_before);
        EXPECT_NEAR(change, 0.5 * size * size * sines, 0.03 * size * size * sines);
      }
}

}  // namespace blossom::occt
