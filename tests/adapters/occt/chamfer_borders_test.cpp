// SPDX-License-Identifier: LGPL-2.1-or-later
// Borders of chamfers beside poles, and past the ends of edges at which faces touch.
#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
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

}  // namespace blossom::occt
