// SPDX-License-Identifier: LGPL-2.1-or-later
// The largest radius that a refusal tells: it works, and one a little larger does not.
#include "adapters/occt/blending/sheet/largest_fillet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Geom_BezierCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <gp.hxx>
#include <gp_Ax2.hxx>
#include <gp_Elips.hxx>
#include <gp_Vec.hxx>

#include "adapters/occt/edge_facts.h"
#include "adapters/occt/fillet.h"

namespace blossom::occt {
namespace {

constexpr double kClose = 2e-6;  // model units: as far as brackets of radii up to 2 are closed
constexpr double kRough = 1e-3;  // of a radius: likewise, where edges have to be rounded
constexpr double kExact = 1e-8;  // model units: where the condition is solved that stops the ball

std::vector<int> edges_that_have(const TopoDS_Shape& shape, EdgeKind kind) {
  std::vector<int> found;
  for (const EdgeFacts& each : edge_facts(shape))
    if (each.kind == kind) found.push_back(each.number);
  return found;
}

int edge_with_middle(const TopoDS_Shape& shape, const Vec3& point) {
  for (const EdgeFacts& each : edge_facts(shape))
    if (distance(each.middle, point) < 1e-6) return each.number;
  return 0;
}

// Refused, and told a radius that works, above which there is none that is asked for here.
void expect_told(const TopoDS_Shape& shape, const std::vector<int>& edges, double radius,
                 double largest, double close) {
  const FilletResult made = fillet(shape, edges, {.radius = radius});
  EXPECT_TRUE(made.solids.empty());
  ASSERT_EQ(made.refused.size(), 1U);
  const FilletRefusal& why = made.refused.front();
  ASSERT_TRUE(why.largest) << why.text();
  EXPECT_NEAR(*why.largest, largest, close) << why.text();
  const FilletResult below = fillet(shape, edges, {.radius = *why.largest});
  ASSERT_EQ(below.solids.size(), 1U) << below.refused.front().text();
  EXPECT_TRUE(BRepCheck_Analyzer(below.solids.front().solid).IsValid());
}

TEST(LargestFillet, OfAnEdgeOfABoxIsAsWideAsItsFaces) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 10, 10).Shape();
  for (const double radius : {10.01, 13.0, 1000.0}) expect_told(box, {1}, radius, 10, kExact);
}

TEST(LargestFillet, OfTwoEdgesThatShareAFaceIsHalfOfIt) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 10, 10).Shape();
  const std::vector<int> edges{edge_with_middle(box, {5, 0, 10}),
                               edge_with_middle(box, {5, 10, 10})};
  expect_told(box, edges, 6, 5, kExact);
}

TEST(LargestFillet, OfAllEdgesOfABoxIsHalfItsLeastSide) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 8, 6).Shape();
  std::vector<int> edges(12);
  std::iota(edges.begin(), edges.end(), 1);
  expect_told(box, edges, 4, 3, kExact);
}

// No ball beside an edge is too large, but two strips run into each other between the rims.
TEST(LargestFillet, IsFoundWhereOnlyResultsTellIt) {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(20, 20, 10).Shape();
  const TopoDS_Shape bored =
      BRepAlgoAPI_Cut(block, BRepPrimAPI_MakeCylinder(gp_Ax2({10, 10, -1}, {0, 0, 1}), 8, 12))
          .Shape();
  expect_told(bored, edges_that_have(bored, EdgeKind::Convex), 1.5, 1, kRough);
}

// Radii from where the rims' strips meet on: one answer, of the ladder and of what is near the
// place.
TEST(LargestFillet, IsTheSameWhateverRadiusIsAskedFor) {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(20, 20, 10).Shape();
  const TopoDS_Shape bored =
      BRepAlgoAPI_Cut(block, BRepPrimAPI_MakeCylinder(gp_Ax2({10, 10, -1}, {0, 0, 1}), 8, 12))
          .Shape();
  const std::vector<int> edges = edges_that_have(bored, EdgeKind::Convex);
  double first = 0;
  for (const double radius : {1.1, 1.5, 2.0, 3.1, 7.0}) {
    const FilletResult made = fillet(bored, edges, {.radius = radius});
    ASSERT_EQ(made.refused.size(), 1U);
    const FilletRefusal& why = made.refused.front();
    ASSERT_TRUE(why.largest) << why.text();
    EXPECT_FALSE(why.at_least);
    if (first == 0) first = *why.largest;
    EXPECT_NEAR(*why.largest, first, 1e-9 * first) << radius;
  }
}

// A step with a notch 2 beside its edge, past which the concave edge's strip cannot go. What the
// first attempt at it widened must not count in the next ones.
TEST(LargestFillet, IsFoundAfterAnAttemptThatFails) {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(20, 40, 20).Shape();
  const TopoDS_Shape step =
      BRepAlgoAPI_Cut(block, BRepPrimAPI_MakeBox(gp_Pnt(10, -1, 12), 20, 50, 20).Shape()).Shape();
  const TopoDS_Shape notched =
      BRepAlgoAPI_Cut(step, BRepPrimAPI_MakeBox(gp_Pnt(12, 36, -1), 20, 10, 30).Shape()).Shape();
  expect_told(notched, {edge_with_middle(notched, {10, 20, 12})}, 3, 2, kClose);
}

// A wall across the trough z = 2 x^2, whose least radius of curvature is 1/4.
TEST(LargestFillet, OfATroughIsItsRadiusOfCurvature) {
  TColgp_Array1OfPnt poles(1, 3);
  poles(1) = {-1, 0, 2};
  poles(2) = {0, 0, -2};
  poles(3) = {1, 0, 2};
  BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(new Geom_BezierCurve(poles)));
  wire.Add(BRepBuilderAPI_MakeEdge(poles(3), {1, 0, -1}));
  wire.Add(BRepBuilderAPI_MakeEdge({1, 0, -1}, {-1, 0, -1}));
  wire.Add(BRepBuilderAPI_MakeEdge({-1, 0, -1}, poles(1)));
  const TopoDS_Shape trough =
      BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire), gp_Vec(0, 2, 0)).Shape();
  const TopoDS_Shape wall = BRepPrimAPI_MakeBox(gp_Pnt(-1, -0.5, -1), 2, 0.5, 5).Shape();
  const TopoDS_Shape shape = BRepAlgoAPI_Fuse(trough, wall).Shape();
  expect_told(shape, {edge_with_middle(shape, {0, 0, 0})}, 0.3, 0.25, kExact);
}

// The floor of a channel is 1 wide.
// Its wall turns most where two edges of its rim follow each other, away from their middles: balls
// that fit there are stopped on the way, by the curvature that b^2 / a is the least radius of.
TEST(LargestFillet, OfAnEllipticPocketIsItsLeastRadiusOfCurvature) {
  const gp_Elips ellipse(gp_Ax2({0, 0, -4}, {0, 0, 1}, {1, 0, 0}), 8, 2);
  BRepBuilderAPI_MakeWire rim;
  rim.Add(BRepBuilderAPI_MakeEdge(ellipse, 0, std::numbers::pi));
  rim.Add(BRepBuilderAPI_MakeEdge(ellipse, std::numbers::pi, 2 * std::numbers::pi));
  const TopoDS_Shape core =
      BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(rim.Wire()), gp_Vec(0, 0, 8)).Shape();
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(-10, -5, -8), gp_Pnt(10, 5, 0)).Shape();
  const TopoDS_Shape pocket = BRepAlgoAPI_Cut(block, core).Shape();
  const std::vector<int> floor = edges_that_have(pocket, EdgeKind::Concave);
  ASSERT_EQ(floor.size(), 2U);
  const FilletResult made = fillet(pocket, floor, {.radius = 0.7});
  ASSERT_EQ(made.refused.size(), 1U);
  EXPECT_EQ(made.refused.front().fault, FilletFault::Pinch) << made.refused.front().text();
  expect_told(pocket, floor, 0.7, 0.5, kClose);
}

TEST(LargestFillet, OfBothEdgesOfAChannelIsHalfItsFloor) {
  const TopoDS_Shape shape =
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(3, 6, 3).Shape(),
                      BRepPrimAPI_MakeBox(gp_Pnt(1, -1, 1), 1, 8, 2.5).Shape())
          .Shape();
  expect_told(shape, edges_that_have(shape, EdgeKind::Concave), 0.8, 0.5, kExact);
}

// A plate in the shape of an L, whose arms end in faces that are as wide as the arms.
TopoDS_Shape ell(double first, double second) {
  const TopoDS_Shape a = BRepPrimAPI_MakeBox(30, first, 6).Shape();
  return BRepAlgoAPI_Fuse(a, BRepPrimAPI_MakeBox(second, 30, 6).Shape()).Shape();
}

// At half the thickness what is left of the narrow faces has no width: a little less leaves a sound
// solid, and a little more none.
TEST(LargestFillet, OfAllEdgesOfAnAngleIsJustBelowHalfItsThickness) {
  const TopoDS_Shape arm = BRepPrimAPI_MakeBox(80, 50, 8).Shape();
  BRepAlgoAPI_Fuse fused(arm, BRepPrimAPI_MakeBox(8, 50, 60).Shape());
  fused.SimplifyResult();
  const TopoDS_Shape shape = fused.Shape();
  const std::vector<int> edges = edges_that_have(shape, EdgeKind::Convex);
  expect_told(shape, edges, 20, 4, 1e-5);
  const FilletResult made = fillet(shape, edges, {.radius = 20});
  ASSERT_EQ(made.refused.size(), 1U);
  EXPECT_NE(made.refused.front().text().find("stopped by another blend"), std::string::npos)
      << made.refused.front().text();
}

// Whichever of two edges far from each other is refused, both are rounded with the radius told.
TEST(LargestFillet, OfEdgesFarFromEachOtherIsThatOfTheTighterOne) {
  for (const bool turned : {false, true}) {
    const double first = turned ? 2 : 4, second = turned ? 4 : 2;
    const TopoDS_Shape shape = ell(first, second);
    const std::vector<int> edges{edge_with_middle(shape, {30, first, 3}),
                                 edge_with_middle(shape, {second, 30, 3})};
    expect_told(shape, edges, 5, 2, kExact);
  }
}

// At the radius 1/11 a contact comes to a smooth edge in its end, where it is not told on which
// side it is; smaller and larger balls go on there.
TEST(LargestFillet, IsNotThatOfALimitAtWhichAloneNoneIsMade) {
  const TopoDS_Shape body =
      BRepAlgoAPI_Fuse(
          BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -10), gp::DZ()), 20, 20).Shape(),
          BRepPrimAPI_MakeBox(gp_Pnt(-10, 15, -5), 40, 40, 15).Shape())
          .Shape();
  const TopoDS_Shape ring =
      BRepPrimAPI_MakeTorus(gp_Ax2(gp_Pnt(15, 5, 0), gp::DX()), 12, 6).Shape();
  BRepAlgoAPI_Cut cut(body, ring);
  cut.SimplifyResult();
  const TopoDS_Shape shape = cut.Shape();
  const FilletResult made =
      fillet(shape, edges_that_have(shape, EdgeKind::Convex), {.radius = 1.178});
  ASSERT_EQ(made.refused.size(), 1U);
  ASSERT_TRUE(made.refused.front().largest);
  EXPECT_NEAR(*made.refused.front().largest, 0.885, kRough);
}

// Each trial rounds more edges than all that follow the first may.
TEST(LargestFillet, IsFoundByHalvesHoweverManyEdgesThereAre) {
  BRepBuilderAPI_MakePolygon star;
  for (int i = 0; i < 240; ++i) {
    const double turn = std::numbers::pi * i / 120, radius = i % 2 == 0 ? 40 : 50;
    star.Add(gp_Pnt(radius * std::cos(turn), radius * std::sin(turn), 0));
  }
  star.Close();
  const TopoDS_Shape prism =
      BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(star.Wire()).Shape(), gp_Vec(0, 0, 10)).Shape();
  const FilletResult made = fillet(prism, edges_that_have(prism, EdgeKind::Convex), {.radius = 20});
  ASSERT_EQ(made.refused.size(), 1U);
  EXPECT_TRUE(made.refused.front().largest) << made.refused.front().text();
}

TEST(LargestFillet, IsNotLookedForWhereItIsNotWanted) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 10, 10).Shape();
  const FilletResult made = fillet(box, {1}, {.radius = 11, .largest = false});
  ASSERT_EQ(made.refused.size(), 1U);
  EXPECT_FALSE(made.refused.front().largest);
}

TEST(LargestFillet, IsToldInDigitsThatWork) {
  const FilletRefusal why{FilletFault::NoBall, 3, "too large", {}, {}, 8.93829999};
  EXPECT_NE(why.text().find("works is 8.93829"), std::string::npos) << why.text();
}

TEST(LargestFillet, IsAtLeastWhatWorkedWhereTheSearchEndedEarly) {
  FilletRefusal why{FilletFault::NoBall, 3, "too large", {}, {}, 2};
  why.at_least = true;
  EXPECT_NE(why.text().find("the largest radius that works is at least 2"), std::string::npos)
      << why.text();
}

}  // namespace
}  // namespace blossom::occt
