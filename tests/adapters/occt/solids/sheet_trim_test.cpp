// SPDX-License-Identifier: LGPL-2.1-or-later
// Sheets combined with solids and with each other: areas in closed form, and what has no meaning.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <gp.hxx>
#include <gp_Ax2.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>

#include "adapters/occt/faces/area.h"
#include "adapters/occt/half_space.h"
#include "adapters/occt/solid_trim.h"
#include "core/base/errors.h"
#include "tests/support/measures.h"

namespace blossom::occt {
namespace {

using testing::kPi;
using Areas = std::vector<double>;
constexpr double kClose = 1e-6;  // square model units

const TopoDS_Shape& block() {
  static const TopoDS_Shape made = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(2, 2, 2)).Shape();
  return made;
}

TopoDS_Shape plate(const gp_Pnt& point, const gp_Dir& normal, double reach) {
  return BRepBuilderAPI_MakeFace(gp_Pln(point, normal), -reach, reach, -reach, reach).Shape();
}

// The sides of the cube, without its bottom and top.
TopoDS_Shape walls() {
  BRepBuilderAPI_Sewing sewing;
  int number = 0;
  for (TopExp_Explorer it(block(), TopAbs_FACE); it.More() && number < 4; it.Next(), ++number)
    sewing.Add(it.Current());
  sewing.Perform();
  return sewing.SewedShape();
}

SolidTrimResult made_of(const TopoDS_Shape& part, const std::vector<TopoDS_Shape>& tools,
                        SolidOperation operation) {
  std::vector<TrimTool> others;
  for (const TopoDS_Shape& tool : tools) others.push_back(trim_tool(tool));
  return trim_solids(trim_tool(part), others, operation);
}

Areas areas_of(const SolidTrimResult& made) {
  EXPECT_EQ(made.obstacles, std::vector<std::string>{});
  EXPECT_TRUE(made.solids.empty());
  Areas areas;
  for (const TopoDS_Shell& sheet : made.sheets) {
    EXPECT_TRUE(BRepCheck_Analyzer(sheet).IsValid());
    double sum = 0;
    for (TopExp_Explorer it(sheet, TopAbs_FACE); it.More(); it.Next())
      sum += area(TopoDS::Face(it.Current()));
    areas.push_back(sum);
  }
  std::ranges::sort(areas);
  return areas;
}

void expect_areas(const SolidTrimResult& made, const Areas& wanted) {
  const Areas areas = areas_of(made);
  ASSERT_EQ(areas.size(), wanted.size());
  double whole = 0;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_NEAR(areas[i], wanted[i], kClose);
    whole += wanted[i];
  }
  EXPECT_NEAR(made.areas.result, whole, kClose);
}

TEST(SheetTrim, APlateIsLeftOutsideOfABoxOrInsideOfIt) {
  const TopoDS_Shape wide = plate({1, 1, 1}, {0, 0, 1}, 3);
  expect_areas(made_of(wide, {block()}, SolidOperation::Cut), {32});
  expect_areas(made_of(wide, {block()}, SolidOperation::Common), {4});
  const SolidTrimResult split = made_of(wide, {block()}, SolidOperation::Split);
  expect_areas(split, {36});  // in two faces, which hang together
  EXPECT_EQ(split.faces.size(), 2u);
  EXPECT_EQ(split.areas.part, 36);
}

TEST(SheetTrim, ASolidHasInCommonWithASheetWhatOfTheSheetLiesInIt) {
  const SolidTrimResult made =
      made_of(block(), {plate({1, 1, 1}, {1, 1, 1}, 5)}, SolidOperation::Common);
  expect_areas(made, {3 * std::sqrt(3.0)});  // a hexagon of side sqrt(2)
  ASSERT_EQ(made.faces.size(), 1u);
  EXPECT_EQ(made.faces.front().tool, 0);
}

TEST(SheetTrim, WhatLiesOnASolidIsInCommonWithIt) {
  const TopoDS_Shape lid = plate({1, 1, 2}, {0, 0, 1}, 3);
  expect_areas(made_of(lid, {block()}, SolidOperation::Common), {4});
  expect_areas(made_of(lid, {block()}, SolidOperation::Cut), {32});
}

TEST(SheetTrim, AShellOfSeveralFacesKeepsItsEdges) {
  const TopoDS_Shape drill =
      BRepPrimAPI_MakeCylinder(gp_Ax2({1, 1, -1}, {0, 0, 1}), 1.25, 2).Shape();
  const SolidTrimResult made = made_of(walls(), {drill}, SolidOperation::Cut);
  // Of each wall the half of height 1 has a chord of 1.5 in the drill.
  expect_areas(made, {16 - 4 * 1.5});
  EXPECT_EQ(made.faces.size(), 4u);
}

TEST(SheetTrim, CurvedSheetsAreCutAsSolidsAre) {
  const TopoDS_Shape skin = BRepBuilderAPI_MakeFace(gp_Sphere({{0, 0, 0}, {0, 0, 1}}, 1)).Shape();
  expect_areas(made_of(skin, {block()}, SolidOperation::Common), {kPi / 2});
  expect_areas(made_of(skin, {block()}, SolidOperation::Cut), {3.5 * kPi});
}

TEST(SheetTrim, SeveralToolsOneAfterTheOther) {
  const TopoDS_Shape wide = plate({1, 1, 1}, {0, 0, 1}, 3);
  const TopoDS_Shape second = BRepPrimAPI_MakeBox(gp_Pnt(1, 1, 0), gp_Pnt(3, 3, 2)).Shape();
  expect_areas(made_of(wide, {block(), second}, SolidOperation::Cut), {36 - 7});
  expect_areas(made_of(wide, {block(), second}, SolidOperation::Common), {1});
}

TEST(SheetTrim, SheetsThatCrossAreFusedAlongTheirCommonEdge) {
  const SolidTrimResult made = made_of(plate({0, 0, 0}, {0, 0, 1}, 1),
                                       {plate({0, 0, 0}, {1, 0, 0}, 1)}, SolidOperation::Fuse);
  expect_areas(made, {2, 2, 2, 2});  // an edge of four faces joins none of them to a shell
  TopTools_IndexedMapOfShape edges;
  for (const TopoDS_Shell& sheet : made.sheets) TopExp::MapShapes(sheet, TopAbs_EDGE, edges);
  EXPECT_EQ(edges.Extent(), 4 * 3 + 1);
}

TEST(SheetTrim, SheetsThatCrossHaveNoAreaInCommon) {
  const TopoDS_Shape floor = plate({0, 0, 0}, {0, 0, 1}, 1), wall = plate({0, 0, 0}, {1, 0, 0}, 2);
  EXPECT_TRUE(made_of(floor, {wall}, SolidOperation::Common).sheets.empty());
  expect_areas(made_of(floor, {wall}, SolidOperation::Cut), {4});
}

TEST(SheetTrim, SheetsInOnePlaneHaveARegionInCommon) {
  const TopoDS_Shape left = plate({0, 0, 0}, {0, 0, 1}, 2), right = plate({2, 0, 0}, {0, 0, 1}, 1);
  expect_areas(made_of(left, {right}, SolidOperation::Common), {2});
  expect_areas(made_of(left, {right}, SolidOperation::Cut), {14});
  const SolidTrimResult fused = made_of(left, {right}, SolidOperation::Fuse);
  expect_areas(fused, {18});
  EXPECT_EQ(fused.faces.size(), 3u);
}

TEST(SheetTrim, WhatIsAboveAPlaneCutsASheet) {
  const TopoDS_Shape tube = walls();
  const TrimTool part = trim_tool(tube);
  const TrimTool above = half_space_tool({{0, 0, 0.5}, {0, 0, 1}}, tube, "plane 1");
  expect_areas(trim_solids(part, {above}, SolidOperation::Cut), {4});
  expect_areas(trim_solids(part, {above}, SolidOperation::Common), {12});
}

TEST(SheetTrim, NothingIsLeftWhereTheyDoNotMeet) {
  const TopoDS_Shape far = plate({9, 9, 9}, {0, 0, 1}, 1);
  const SolidTrimResult made = made_of(far, {block()}, SolidOperation::Common);
  EXPECT_TRUE(made.obstacles.empty());
  EXPECT_TRUE(made.sheets.empty());
  expect_areas(made_of(far, {block()}, SolidOperation::Cut), {4});
}

TEST(SheetTrim, RefusesWhatHasNoMeaning) {
  const TopoDS_Shape sheet = plate({1, 1, 1}, {0, 0, 1}, 3);
  EXPECT_THROW(made_of(block(), {sheet}, SolidOperation::Cut), InvalidInput);
  EXPECT_THROW(made_of(block(), {sheet}, SolidOperation::Fuse), InvalidInput);
  EXPECT_THROW(made_of(sheet, {block()}, SolidOperation::Fuse), InvalidInput);
}

// The wall lies on both boxes, which touch there: each point of it is in common once.
TEST(SheetTrim, WhatTwoTouchingSolidsHaveInCommonWithASheetCountsOnce) {
  BRep_Builder builder;
  TopoDS_Compound boxes;
  builder.MakeCompound(boxes);
  builder.Add(boxes, BRepPrimAPI_MakeBox(gp_Pnt(-10, -5, -5), gp_Pnt(0, 5, 5)).Shape());
  builder.Add(boxes, BRepPrimAPI_MakeBox(gp_Pnt(0, -5, -5), gp_Pnt(10, 5, 5)).Shape());
  const TopoDS_Shape wall = plate(gp_Pnt(0, 0, 0), gp::DX(), 10);
  const auto area_of = [&](SolidOperation operation) {
    double sum = 0;
    for (const SolidFace& face : made_of(wall, {boxes}, operation).faces) sum += area(face.face);
    return sum;
  };
  EXPECT_NEAR(area_of(SolidOperation::Common), 100, kClose);
  EXPECT_NEAR(area_of(SolidOperation::Cut), 300, kClose);
}

}  // namespace
}  // namespace blossom::occt
