// SPDX-License-Identifier: LGPL-2.1-or-later
// Wires, edges and vertices combined with each other, with sheets and with solids.
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Circ.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/solid_trim.h"
#include "core/base/errors.h"

namespace blossom::occt {
namespace {

constexpr double kPi = std::numbers::pi;
const gp_Dir kUp(0, 0, 1);

TopoDS_Shape line(const gp_Pnt& from, const gp_Pnt& to) {
  return BRepBuilderAPI_MakeEdge(from, to).Edge();
}

TopoDS_Shape circle(const gp_Pnt& middle, double radius) {
  return BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(middle, kUp), radius)).Edge();
}

TopoDS_Shape arc(double radius, double from, double to) {
  return BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp_Pnt(), kUp), radius), from, to).Edge();
}

TopoDS_Shape vertex(double x, double y, double z) {
  return BRepBuilderAPI_MakeVertex(gp_Pnt(x, y, z)).Vertex();
}

TopoDS_Shape box() { return BRepPrimAPI_MakeBox(4., 4., 4.).Shape(); }

SolidTrimResult made_of(const TopoDS_Shape& part, const TopoDS_Shape& tool,
                        SolidOperation operation) {
  return trim_solids(trim_tool(part), {trim_tool(tool)}, operation);
}

int count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, kind, map);
  return map.Extent();
}

struct Made {
  double length = 0;
  int edges = 0;
  int vertices = 0;
  Status status = Status::Complete;
};

void expect(const SolidTrimResult& made, const Made& wanted) {
  ASSERT_TRUE(made.obstacles.empty()) << made.obstacles.front();
  EXPECT_EQ(made.status, wanted.status);
  EXPECT_NEAR(made.lengths.result, wanted.length, 1e-7);
  EXPECT_EQ(count(made.wires, TopAbs_EDGE), wanted.edges);
  EXPECT_EQ(count(made.wires, TopAbs_VERTEX), wanted.vertices);
}

TEST(WireTrim, ALineThroughASolidIsCutWhereItMeetsIt) {
  const TopoDS_Shape through = line({-1, 2, 2}, {6, 2, 2});
  expect(made_of(through, box(), SolidOperation::Cut), {3, 2, 4});
  expect(made_of(through, box(), SolidOperation::Common), {4, 1, 2});
  expect(made_of(box(), through, SolidOperation::Common), {4, 1, 2});
  expect(made_of(through, box(), SolidOperation::Split), {7, 3, 4});
}

TEST(WireTrim, WhatLiesInAFaceIsInCommonWithIt) {
  const TopoDS_Shape in_top = line({1, 1, 4}, {6, 2, 4});
  const double inside = std::hypot(3, 0.6);
  expect(made_of(in_top, box(), SolidOperation::Common), {inside, 1, 2});
  expect(made_of(in_top, box(), SolidOperation::Cut), {std::hypot(5, 1) - inside, 1, 2});
  const TopoDS_Shape above = BRepBuilderAPI_MakeFace(gp_Pln({0, 0, 4}, kUp), 0, 3, 0, 3).Face();
  const double on_sheet = std::hypot(2, 0.4);
  expect(made_of(above, in_top, SolidOperation::Common), {on_sheet, 1, 2});
  expect(made_of(in_top, above, SolidOperation::Cut), {std::hypot(5, 1) - on_sheet, 1, 2});
}

TEST(WireTrim, WhatRunsAlongAnEdgeIsInCommonWithIt) {
  expect(made_of(line({-1, 0, 4}, {2, 0, 4}), box(), SolidOperation::Common), {2, 1, 2});
  expect(made_of(arc(2, 0, 2), arc(2, 1, 3), SolidOperation::Common), {2, 1, 2});
  expect(made_of(arc(2, 0, 2), arc(2, 1, 3), SolidOperation::Cut), {2, 1, 2});
}

// It begins beside the sphere's own seam, and lies on the sphere from end to end.
TEST(WireTrim, ACircleMayLieOnASphere) {
  const TopoDS_Shape sphere = BRepPrimAPI_MakeSphere(2.).Shape();
  const TopoDS_Shape on = circle({0, 0, 1}, std::sqrt(3.));
  const SolidTrimResult common = made_of(on, sphere, SolidOperation::Common);
  ASSERT_TRUE(common.obstacles.empty());
  EXPECT_NEAR(common.lengths.result, 2 * kPi * std::sqrt(3.), 1e-7);
  expect(made_of(on, sphere, SolidOperation::Cut), {0, 0, 0});
  EXPECT_NEAR(made_of(circle({2, 0, 0}, 2), sphere, SolidOperation::Common).lengths.result,
              2 * 2 * kPi / 3, 1e-6);
}

// Round the cylinder the face goes over where its parameter begins, so that feet are a period off.
TEST(WireTrim, AFaceMayGoAcrossItsSeam) {
  const gp_Cylinder round(gp_Ax3(gp_Pnt(), kUp), 2);
  const double x = 2 * std::cos(0.5), y = 2 * std::sin(0.5);
  const TopoDS_Shape on = line({x, y, -1}, {x, y, 3});
  for (const double turns : {0, 2}) {
    const double from = (1.5 + 2 * turns) * kPi;
    const TopoDS_Shape face = BRepBuilderAPI_MakeFace(round, from, from + kPi, 0, 4).Face();
    expect(made_of(on, face, SolidOperation::Common), {3, 1, 2});
    expect(made_of(on, face, SolidOperation::Cut), {1, 1, 2});
  }
}

// Within tolerance of it for some 1e-3.
TEST(WireTrim, ACircleMayTouchAFace) {
  expect(made_of(circle({2, 2, 6}, 2), box(), SolidOperation::Common), {0, 0, 0});
  const TopoDS_Shape upright =
      BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2({2, 2, 6}, gp_Dir(0, 1, 0)), 2)).Edge();
  expect(made_of(upright, box(), SolidOperation::Common), {0, 0, 0});
  EXPECT_NEAR(made_of(upright, box(), SolidOperation::Cut).lengths.result, 4 * kPi, 1e-7);
}

TEST(WireTrim, EdgesThatCrossHaveNothingInCommonAndDivideEachOther) {
  const TopoDS_Shape through = line({-1, 2, 2}, {6, 2, 2}), round = circle({2, 2, 2}, 3);
  expect(made_of(through, round, SolidOperation::Common), {0, 0, 0});
  expect(made_of(through, round, SolidOperation::Cut), {7, 2, 3});
  expect(made_of(through, round, SolidOperation::Fuse), {7 + 6 * kPi, 4, 3});
}

TEST(WireTrim, FusedWiresHaveEachStretchOnce) {
  expect(made_of(arc(2, 0, 2), arc(2, 1, 3), SolidOperation::Fuse), {6, 3, 4});
  const TopoDS_Shape round = circle({0, 0, 0}, 3);
  expect(made_of(round, round, SolidOperation::Fuse), {6 * kPi, 1, 1});
}

TEST(WireTrim, VerticesAreInOrOutside) {
  for (const gp_Pnt& at : {gp_Pnt(2, 2, 2), gp_Pnt(2, 2, 4), gp_Pnt(2, 0, 4), gp_Pnt(0, 0, 4)}) {
    const TopoDS_Shape point = vertex(at.X(), at.Y(), at.Z());
    expect(made_of(point, box(), SolidOperation::Common), {0, 0, 1});
    expect(made_of(point, box(), SolidOperation::Cut), {0, 0, 0});
  }
  expect(made_of(vertex(2, 2, 5), box(), SolidOperation::Common), {0, 0, 0});
  expect(made_of(vertex(2, 2, 5), box(), SolidOperation::Cut), {0, 0, 1});
  // A common vertex is of the lowest dimension, whichever comes first.
  const TopoDS_Shape through = line({-1, 2, 2}, {6, 2, 2});
  expect(made_of(through, vertex(2, 2, 2), SolidOperation::Common), {0, 0, 1});
  expect(made_of(vertex(2, 2, 2), vertex(3, 2, 2), SolidOperation::Fuse), {0, 0, 2});
}

// Vertices of the tool that are no ends of its edges.
TEST(WireTrim, CommonVerticesAreSoWhicheverComesFirst) {
  const TopoDS_Shape through = line({-1, 2, 2}, {6, 2, 2});
  const TopoDS_Shape mixed =
      compound_of(std::vector{line({0, 0, 2}, {0, 4, 2}), vertex(3, 2, 2), vertex(3, 3, 2)});
  expect(made_of(through, mixed, SolidOperation::Common), {0, 0, 1});
  expect(made_of(mixed, through, SolidOperation::Common), {0, 0, 1});
}

// A vertex that states much merges no other places than its own.
TEST(WireTrim, PlacesAreOneWithinWhatTheyStateThemselves) {
  TopoDS_Vertex loose;
  BRep_Builder().MakeVertex(loose, gp_Pnt(4, 2, 2), 0.3);
  const TopoDS_Shape tool = compound_of(
      std::vector<TopoDS_Shape>{line({0, 0, 2}, {0, 4, 2}), line({0.2, 0, 2}, {0.2, 4, 2}), loose});
  expect(made_of(line({-1, 2, 2}, {6, 2, 2}), tool, SolidOperation::Cut),
         {7, 4, 5, Status::Tolerance});
}

TEST(WireTrim, OfASolidTrueTolerancesAreUsed) {
  const TopoDS_Shape overstated = box();
  for (TopExp_Explorer it(overstated, TopAbs_EDGE); it.More(); it.Next())
    BRep_Builder().UpdateEdge(TopoDS::Edge(it.Current()), 0.5);
  const SolidTrimResult made =
      made_of(line({-1, -0.2, 4.2}, {5, -0.2, 4.2}), overstated, SolidOperation::Cut);
  expect(made, {6, 1, 2});
  EXPECT_EQ(made.tolerances.size(), 1U);
}

TEST(WireTrim, LooseFacesBesideSolidsAreTold) {
  const TopoDS_Shape sheet = BRepBuilderAPI_MakeFace(gp_Pln({0, 0, 9}, kUp), 0, 3, 0, 3).Face();
  const SolidTrimResult made = made_of(line({-1, 2, 2}, {6, 2, 2}),
                                       compound_of(std::vector{box(), sheet}), SolidOperation::Cut);
  expect(made, {3, 2, 4, Status::Tolerance});
  EXPECT_EQ(made.left_out.size(), 1U);
}

// Also where nothing comes near to anything, so that nothing is searched.
TEST(WireTrim, EndsWhenTheCallerWantsIt) {
  IntersectionOptions options;
  options.cancelled = [] { return true; };
  const TrimTool first =
      trim_tool(compound_of(std::vector{line({0, 0, 0}, {1, 0, 0}), line({0, 1, 0}, {1, 1, 0})}));
  const TrimTool second = trim_tool(line({0, 0, 9}, {1, 0, 9}));
  const SolidTrimResult made = trim_solids(first, {second}, SolidOperation::Fuse, options);
  EXPECT_EQ(made.status, Status::Stopped);
  EXPECT_EQ(made.obstacles.size(), 1U);
}

TEST(WireTrim, ToolsAreTakenOneAfterTheOther) {
  const TrimTool through = trim_tool(line({-1, 2, 2}, {9, 2, 2}));
  const TrimTool first = trim_tool(box());
  const TrimTool second = trim_tool(BRepPrimAPI_MakeBox(gp_Pnt(3, 0, 0), gp_Pnt(7, 4, 4)).Shape());
  expect(trim_solids(through, {first, second}, SolidOperation::Common), {1, 1, 2});
  expect(trim_solids(through, {first, second}, SolidOperation::Cut), {3, 2, 4});
  expect(trim_solids(first, {second, through}, SolidOperation::Common), {1, 1, 2});
}

TEST(WireTrim, WiresTakeNothingOffFacesAndSolids) {
  const TrimTool solid = trim_tool(box()), wire = trim_tool(line({-1, 2, 2}, {6, 2, 2}));
  for (const SolidOperation operation :
       {SolidOperation::Cut, SolidOperation::Fuse, SolidOperation::Split}) {
    EXPECT_NE(misplaced_sheet(solid, {wire}, operation), "");
    EXPECT_THROW(trim_solids(solid, {wire}, operation), InvalidInput);
  }
  EXPECT_NE(misplaced_sheet(wire, {solid}, SolidOperation::Fuse), "");
  EXPECT_EQ(misplaced_sheet(wire, {solid}, SolidOperation::Split), "");
}

}  // namespace
}  // namespace blossom::occt
