// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids divided by sheets: volumes in closed form, and what divides nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Ax2.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>

#include "adapters/occt/faces/area.h"
#include "adapters/occt/solid_trim.h"
#include "tests/support/measures.h"

namespace blossom::occt {
namespace {

using testing::kPi;

const TopoDS_Shape& cube() {
  static const TopoDS_Shape made = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(2, 2, 2)).Shape();
  return made;
}

// A square of the plane through a point, with sides of twice the reach.
TopoDS_Shape flat(const gp_Pnt& point, const gp_Dir& normal, double reach) {
  return BRepBuilderAPI_MakeFace(gp_Pln(point, normal), -reach, reach, -reach, reach).Shape();
}

// What stands on a line from corner to corner, from z = -1 to 3.
TopoDS_Shape folded(const std::vector<gp_Pnt>& corners) {
  BRepBuilderAPI_MakePolygon line;
  for (const gp_Pnt& corner : corners) line.Add(corner);
  return BRepPrimAPI_MakePrism(line.Wire(), gp_Vec(0, 0, 4)).Shape();
}

double volume_of(const TopoDS_Solid& solid) {
  double sum = 0;
  for (const TopoDS_Face& face : solid_tool({solid}).faces) sum += cone_volume(face, {});
  return sum;
}

std::vector<double> volumes_by(const TopoDS_Shape& part, const std::vector<TopoDS_Shape>& sheets) {
  std::vector<TrimTool> tools;
  for (const TopoDS_Shape& sheet : sheets) tools.push_back(trim_tool(sheet));
  const SolidTrimResult made = trim_solids(trim_tool(part), tools, SolidOperation::Split);
  EXPECT_EQ(made.obstacles, std::vector<std::string>{});
  std::vector<double> volumes;
  for (const TopoDS_Solid& solid : made.solids) {
    EXPECT_TRUE(BRepCheck_Analyzer(solid).IsValid());
    EXPECT_TRUE(is_closed_solid(solid));
    volumes.push_back(volume_of(solid));
  }
  std::ranges::sort(volumes);
  return volumes;
}

void expect_split(const TopoDS_Shape& part, const std::vector<TopoDS_Shape>& sheets,
                  const std::vector<double>& wanted) {
  const std::vector<double> volumes = volumes_by(part, sheets);
  ASSERT_EQ(volumes.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(volumes[i], wanted[i], 1e-6);
}

TEST(SheetSplit, AFlatSheetDividesABoxInTwo) {
  expect_split(cube(), {flat({1, 1, 0.5}, {0, 0, 1}, 5)}, {2, 6});
  expect_split(cube(), {flat({1, 1, 1}, {1, 1, 1}, 5)}, {4, 4});
}

TEST(SheetSplit, ASheetMayEndOnTheFacesOfThePart) {
  expect_split(cube(), {flat({1, 1, 0.5}, {0, 0, 1}, 1)}, {2, 6});
}

TEST(SheetSplit, AnOpenTubeDividesABoxInCoreAndRest) {
  const TopoDS_Shape tube =
      BRepBuilderAPI_MakeFace(gp_Cylinder({{1, 1, 0}, {0, 0, 1}}, 0.5), 0, 2 * kPi, -1, 3).Shape();
  expect_split(cube(), {tube}, {kPi / 2, 8 - kPi / 2});
}

TEST(SheetSplit, AFoldedSheetDividesAtItsFold) {
  expect_split(cube(), {folded({{-1, 1, -1}, {1, 1, -1}, {1, 3, -1}})}, {2, 6});
}

TEST(SheetSplit, EachOfSeveralSheetsDividesAllPieces) {
  expect_split(cube(), {flat({1, 1, 0.5}, {0, 0, 1}, 5), flat({1, 1, 1}, {1, 0, 0}, 5)},
               {1, 1, 3, 3});
}

TEST(SheetSplit, FacesThatMeetInAnEdgeOfThreeDivideAtIt) {
  const TopoDS_Shape bent = folded({{-1, 1, -1}, {1, 1, -1}, {1, 3, -1}});
  BRepBuilderAPI_Sewing sewing(1e-7, true, true, true, true);
  sewing.Add(bent);
  sewing.Add(folded({{1, 1, -1}, {3, 1, -1}}));
  sewing.Perform();
  expect_split(cube(), {sewing.SewedShape()}, {2, 2, 4});
}

TEST(SheetSplit, AClosedSheetInsideBoundsABodyAndAVoid) {
  const TopoDS_Shape ball = BRepBuilderAPI_MakeFace(gp_Sphere({{1, 1, 1}, {0, 0, 1}}, 0.5)).Shape();
  expect_split(cube(), {ball}, {kPi / 6, 8 - kPi / 6});
}

TEST(SheetSplit, AFreeFormSheetDividesWithVolumesThatAddUp) {
  TColgp_Array2OfPnt points(1, 6, 1, 6);
  for (int i = 1; i <= 6; ++i)
    for (int j = 1; j <= 6; ++j)
      points.SetValue(i, j, {i - 2.5, j - 2.5, 1 + 0.2 * std::sin(i) * std::cos(j)});
  const Handle(Geom_BSplineSurface) wave = GeomAPI_PointsToBSplineSurface(points).Surface();
  const std::vector<double> volumes =
      volumes_by(cube(), {BRepBuilderAPI_MakeFace(wave, 1e-7).Shape()});
  ASSERT_EQ(volumes.size(), 2U);
  EXPECT_GT(volumes.front(), 3);
  EXPECT_NEAR(volumes.front() + volumes.back(), 8, 1e-6);
}

TEST(SheetSplit, WhatHasOneBodyOnBothSidesDividesNothing) {
  const TopoDS_Shape ring = BRepPrimAPI_MakeTorus(3, 1).Shape();
  const TopoDS_Shape half = BRepBuilderAPI_MakeFace(gp_Pln({3, 0, 0}, {0, 1, 0}), -2, 2, -2, 2);
  const std::vector<double> volumes = volumes_by(ring, {half});
  ASSERT_EQ(volumes.size(), 1U);
  EXPECT_NEAR(volumes.front(), 6 * kPi * kPi, 1e-6);
  expect_split(ring, {flat({0, 0, 0}, {0, 1, 0}, 9)}, {3 * kPi * kPi, 3 * kPi * kPi});
}

TEST(SheetSplit, ASheetThatEndsInsideOfThePartDividesNothing) {
  const TopoDS_Shape half = flat({1, 1, 1}, {1, 0, 0}, 1);  // to y = 2 and z = 2
  expect_split(BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(2, 2, 3)).Shape(), {half}, {12});
  expect_split(BRepPrimAPI_MakeSphere(gp_Pnt(1, 0, 0), 1.5).Shape(), {half}, {4.5 * kPi});
}

TEST(SheetSplit, WhatOfASheetEndsInsideOfThePartIsLeftOut) {
  // Its first two faces take a corner off, and the last one ends in the middle.
  const TopoDS_Shape bent = folded({{-1, 1, -1}, {1, 1, -1}, {1, 3, -1}});
  BRepBuilderAPI_Sewing sewing(1e-7, true, true, true, true);
  sewing.Add(bent);
  sewing.Add(folded({{1, 1, -1}, {1.5, 1, -1}}));
  sewing.Perform();
  expect_split(cube(), {sewing.SewedShape()}, {2, 6});
}

TEST(SheetSplit, ASheetBesideThePartLeavesItWhole) {
  expect_split(cube(), {flat({1, 1, 5}, {0, 0, 1}, 5)}, {8});
}

}  // namespace
}  // namespace blossom::occt
