// SPDX-License-Identifier: LGPL-2.1-or-later
// Balls larger than the rounding between two edges: there is none beside that, and the strips of
// both edges are joined by a fill.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Tool.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Ax1.hxx>
#include <gp_Trsf.hxx>

#include "adapters/occt/blending/continuity.h"
#include "adapters/occt/edge_facts.h"
#include "adapters/occt/fillet.h"
#include "tests/adapters/occt/fillet_checks.h"
#include "tests/adapters/occt/fillet_volumes.h"

namespace blossom::occt {
namespace {

using testing::expect_change;
using testing::expect_sound;
using testing::kCut;
using testing::told;

constexpr double kSmoothFill = 2e-6;  // radians: what strips and fills keep together

// A block from (0, 0, 0) whose edges along z, or the first of them, have a radius.
TopoDS_Shape rounded_block(double length, double width, double height, double radius,
                           std::size_t count = 4) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(length, width, height).Shape();
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(box, TopAbs_EDGE, edges);
  BRepFilletAPI_MakeFillet maker(box);
  std::size_t done = 0;
  for (const EdgeFacts& each : edge_facts(box))
    if (std::abs(each.middle[2] - 0.5 * height) < 1e-9 && done++ < count)
      maker.Add(radius, TopoDS::Edge(edges(each.number)));
  return maker.Shape();
}

// An edge in the plane z = height that is longer than some length.
int straight_edge_at(const TopoDS_Shape& shape, double height, double length) {
  for (const EdgeFacts& each : edge_facts(shape))
    if (std::abs(each.middle[2] - height) < 1e-9 && each.length > length &&
        (each.kind == EdgeKind::Convex || each.kind == EdgeKind::Concave))
      return each.number;
  return 0;
}

// Edges of fills and strips at which normals turn.
int creases_of(const FilletedSolid& made) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(made.solid, TopAbs_FACE, faces);
  std::vector<int> blends;
  for (const FilletFace& each : made.faces)
    if (each.from == 0) blends.push_back(faces.FindIndex(each.face));
  int count = 0;
  for (const EdgeContinuity& each : edge_continuity(made.solid)) {
    const bool of_blend = std::ranges::any_of(
        each.faces, [&](int face) { return std::ranges::count(blends, face) > 0; });
    if (of_blend && each.found && each.found->angle.value > kSmoothFill) ++count;
  }
  return count;
}

// The area of blends on cylinders of a radius, over a quarter of a circle: the length of strips.
double length_of_strips(const FilletedSolid& made, double radius) {
  double length = 0;
  for (const FilletFace& each : made.faces) {
    if (each.from > 0) continue;
    const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(BRep_Tool::Surface(each.face));
    if (cylinder.IsNull() || std::abs(cylinder->Radius() - radius) > 1e-9) continue;
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(each.face, TopAbs_EDGE, edges);
    double most = 0;
    for (int i = 1; i <= edges.Extent(); ++i) {
      double from = 0, to = 0;
      const Handle(Geom_Curve) curve = BRep_Tool::Curve(TopoDS::Edge(edges(i)), from, to);
      most = std::max(most, curve->Value(from).Distance(curve->Value(to)));
    }
    length += most;
  }
  return length;
}

TEST(TightCorner, OfTheTopOfABlockIsFilledSmoothly) {
  const TopoDS_Shape block = rounded_block(40, 30, 20, 2);
  const FilletResult made = fillet(block, {straight_edge_at(block, 20, 20)}, {.radius = 3});
  expect_sound(made);
  ASSERT_FALSE(HasFailure());
  EXPECT_EQ(creases_of(made.solids.front()), 0);
  EXPECT_EQ(made.edges.size(), 8U);
  // Strips go on to the roundings.
  EXPECT_NEAR(length_of_strips(made.solids.front(), 3), 2 * (36 + 26), 1e-6);
  // Between what the strips take of the walls alone and what they take of a block without
  // roundings.
  const double strips = (1 - 0.25 * M_PI) * 9 * 2 * (40 + 30);
  EXPECT_LT(made.solids.front().volume, made.volume_before - 0.7 * strips);
  EXPECT_GT(made.solids.front().volume, made.volume_before - 1.2 * strips);
  ASSERT_EQ(made.notes.size(), 4U) << made.notes.size();
  EXPECT_NE(made.notes.front().find("its corner is filled"), std::string::npos)
      << made.notes.front();
}

TEST(TightCorner, BesideSharpOnesIsFilledAndThoseAreMitred) {
  const TopoDS_Shape block = rounded_block(40, 30, 20, 2, 1);
  std::vector<int> top;
  for (const EdgeFacts& each : edge_facts(block))
    if (std::abs(each.middle[2] - 20) < 1e-9) top.push_back(each.number);
  ASSERT_EQ(top.size(), 5U);
  expect_sound(fillet(block, top, {.radius = 3}));
}

// With the radius of the rounding the ball turns on the spot; with one a little larger the fill
// takes as much as that sphere to a hundredth.
TEST(TightCorner, IsNearTheSphereOfTheBallWhereTheRoundingHasNearlyItsRadius) {
  const TopoDS_Shape block = rounded_block(20, 20, 10, 3, 1);
  const auto taken = [&](double radius) {
    const FilletResult made = fillet(block, {straight_edge_at(block, 10, 16)}, {.radius = radius});
    expect_sound(made);
    return made.solids.empty() ? 0 : made.volume_before - made.solids.front().volume;
  };
  const double at_radius = taken(3);
  EXPECT_NEAR(taken(3.0001), at_radius, 1e-2 * at_radius);
  EXPECT_LT(at_radius, taken(4));
  EXPECT_LT(taken(4), taken(5));
}

// As one that files tell in seven digits.
TEST(TightCorner, IsTheSphereOfTheBallWhereTheRoundingHasItsRadiusButForDigits) {
  const double change = 34 * 9 * kCut + 27 * M_PI * (1.0 / 4 - 1.0 / 6);
  for (const double off : {-9e-7, -1e-8, 1e-8, 9e-7}) {
    const TopoDS_Shape block = rounded_block(20, 20, 10, 3 + off, 1);
    const FilletResult made = fillet(block, {straight_edge_at(block, 10, 16)}, {.radius = 3});
    expect_change(made, -change, 1e-5);
    expect_sound(made);
    EXPECT_TRUE(made.notes.empty()) << off;
    ASSERT_FALSE(HasFailure()) << off;
    EXPECT_EQ(creases_of(made.solids.front()), 2) << off;  // at its ends
  }
}

TEST(TightCorner, OfTheFloorOfAPocketIsFilledSmoothly) {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(-10, -10, -5), 60, 50, 20).Shape();
  const TopoDS_Shape pocket = BRepAlgoAPI_Cut(block, rounded_block(40, 30, 20, 2)).Shape();
  const FilletResult made = fillet(pocket, {straight_edge_at(pocket, 0, 20)}, {.radius = 3});
  expect_sound(made);
  ASSERT_FALSE(HasFailure());
  EXPECT_EQ(creases_of(made.solids.front()), 0);
  EXPECT_GT(made.solids.front().volume, made.volume_before);
}

// The ball's contacts come to the ends of the rounding one after the other.
TEST(TightCorner, BesideSlantingWallsIsFilledSmoothly) {
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(1, 2, 0)), 0.25);
  const TopoDS_Shape slanted = BRepBuilderAPI_Transform(rounded_block(40, 30, 60, 2), turn).Shape();
  const TopoDS_Shape half = BRepPrimAPI_MakeBox(gp_Pnt(-100, -100, 20), 200, 200, 200).Shape();
  const TopoDS_Shape shape = BRepAlgoAPI_Cut(slanted, half).Shape();
  const FilletResult made = fillet(shape, {straight_edge_at(shape, 20, 20)}, {.radius = 3});
  expect_sound(made);
  ASSERT_FALSE(HasFailure());
  EXPECT_EQ(creases_of(made.solids.front()), 0);
}

// A fill of three sides, one of them much shorter than the others, would bulge out of the walls.
TEST(TightCorner, OfAVerySmallRadiusIsRefusedWithTheLargestThatKeepsInsideOfTheWalls) {
  const TopoDS_Shape block = rounded_block(40, 30, 20, 0.25);
  const FilletResult made = fillet(block, {straight_edge_at(block, 20, 20)}, {.radius = 4});
  EXPECT_TRUE(made.solids.empty());
  ASSERT_FALSE(made.refused.empty());
  EXPECT_NE(made.refused.front().cause.find("goes beyond the faces"), std::string::npos);
  ASSERT_TRUE(made.refused.front().largest.has_value()) << told(made);
  EXPECT_GT(*made.refused.front().largest, 7 * 0.25);
}

TEST(TightCorner, IsRefusedWhereTheStripsBesideItDoNotCross) {
  // A rib that ends in half a cylinder: strips of both sides lie beyond each other.
  const TopoDS_Shape rib = rounded_block(40, 4, 20, 1.999);
  const FilletResult made = fillet(rib, {straight_edge_at(rib, 20, 20)}, {.radius = 3});
  EXPECT_TRUE(made.solids.empty());
  ASSERT_FALSE(made.refused.empty());
  ASSERT_TRUE(made.refused.front().largest.has_value()) << told(made);
  EXPECT_NEAR(*made.refused.front().largest, 1.999, 2e-3);
}

}  // namespace
}  // namespace blossom::occt
