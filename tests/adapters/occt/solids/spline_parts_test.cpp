// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids whose curved faces are parts of one B-spline surface.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS_Shape.hxx>

#include "adapters/occt/intersection.h"
#include "adapters/occt/solid_trim.h"

namespace blossom::occt {
namespace {

// A wavy surface of 5 x 5 spans over the square from 0 to 21, about 10 above it.
Handle(Geom_BSplineSurface) waves() {
  constexpr int kSide = 8;
  TColgp_Array2OfPnt poles(1, kSide, 1, kSide);
  for (int i = 0; i < kSide; ++i)
    for (int j = 0; j < kSide; ++j)
      poles.SetValue(i + 1, j + 1,
                     gp_Pnt(3 * i, 3 * j, 10 + 1.5 * std::sin(2.3 * i + 1.7 * j * j)));
  TColStd_Array1OfReal knots(1, 6);
  TColStd_Array1OfInteger multiplicities(1, 6);
  for (int k = 0; k < 6; ++k) {
    knots.SetValue(k + 1, 0.2 * k);
    multiplicities.SetValue(k + 1, k == 0 || k == 5 ? 4 : 1);
  }
  return new Geom_BSplineSurface(poles, knots, knots, multiplicities, multiplicities, 3, 3);
}

// What stands on a surface over a rectangle, 20 high.
TopoDS_Shape block(const Handle(Geom_BSplineSurface) & below, double x0, double x1, double y0,
                   double y1) {
  const TopoDS_Shape all =
      BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(below, 1e-7).Face(), gp_Vec(0, 0, 20)).Shape();
  BRepAlgoAPI_Common made(all, BRepPrimAPI_MakeBox({x0, y0, -10}, {x1, y1, 50}).Shape());
  return made.Shape();
}

SolidTrimResult blocks_when(SolidOperation operation, const TopoDS_Shape& a,
                            const TopoDS_Shape& b) {
  IntersectionOptions options;
  options.time_limit = 60;
  const SolidTrimResult made = trim_solids(trim_tool(a), {trim_tool(b)}, operation, options);
  EXPECT_EQ(made.obstacles.empty() ? std::string() : made.obstacles.front(), "");
  for (const TopoDS_Solid& solid : made.solids) EXPECT_TRUE(BRepCheck_Analyzer(solid).IsValid());
  return made;
}

void expect_common_area(const TopoDS_Shape& a, const TopoDS_Shape& b, double area) {
  EXPECT_NEAR(blocks_when(SolidOperation::Common, a, b).total.result, 20 * area, 1e-5 * area);
}

TEST(SplineParts, BlocksOverPartsOfOneSplineHaveInCommonWhatTheirPlansHave) {
  const TopoDS_Shape part = block(waves(), 4, 12, 5, 16);
  const TopoDS_Shape other = block(waves(), 8, 17, 7, 18);
  const double common = 20 * 4 * 9, near = 1e-5 * common;
  const SolidTrimResult left = blocks_when(SolidOperation::Cut, part, other);
  EXPECT_NEAR(left.total.result, left.total.part - common, near);
  const SolidTrimResult both = blocks_when(SolidOperation::Fuse, part, other);
  EXPECT_NEAR(both.total.result, both.total.part + both.total.tools - common, near);
  expect_common_area(part, other, 4 * 9);
}

TEST(SplineParts, ASplineMayHaveMoreKnotsThanTheOtherOrBeAPartOfIt) {
  const TopoDS_Shape part = block(waves(), 4, 12, 5, 16);
  const Handle(Geom_BSplineSurface) divided = waves(), shorter = waves();
  divided->InsertUKnot(0.37, 1, 1e-9);
  divided->InsertVKnot(0.61, 1, 1e-9);
  expect_common_area(part, block(divided, 8, 17, 7, 18), 4 * 9);
  shorter->Segment(0.1, 0.9, 0.1, 0.9);
  expect_common_area(part, block(shorter, 8, 16, 6, 14), 4 * 8);
}

TEST(SplineParts, ASplineMayBeWrittenFromAnotherCorner) {
  const TopoDS_Shape part = block(waves(), 4, 12, 5, 16);
  const Handle(Geom_BSplineSurface) turned = waves();
  turned->ExchangeUV();
  turned->UReverse();
  expect_common_area(part, block(turned, 8, 17, 7, 18), 4 * 9);
}

// Its two ends cross: what the faces have in common is more than the outlines tell.
TEST(SplineParts, FacesOfASplineThatCrossesItselfAreSearched) {
  TColgp_Array2OfPnt poles(1, 4, 1, 2);
  const double x[] = {0, 3, -2, 1}, y[] = {0, 2, 2, 0};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 2; ++j) poles.SetValue(i + 1, j + 1, gp_Pnt(x[i], y[i], 5 * j));
  TColStd_Array1OfReal knots(1, 2);
  TColStd_Array1OfInteger ends(1, 2), along(1, 2);
  for (int k = 1; k <= 2; ++k) {
    knots.SetValue(k, k - 1);
    ends.SetValue(k, 4);
    along.SetValue(k, 2);
  }
  const Handle(Geom_BSplineSurface) loop =
      new Geom_BSplineSurface(poles, knots, knots, ends, along, 3, 1);
  const auto part = [&](double from, double to) {
    return BRepBuilderAPI_MakeFace(loop, from, to, 0, 1, 1e-7).Face();
  };
  const ShapeIntersection found = intersect({part(0, 0.4)}, {part(0.6, 1)});
  double length = 0;
  for (const FaceIntersection& pair : found.pairs)
    for (const IntersectionCurve& curve : pair.found.curves) length += curve.length;
  EXPECT_NEAR(length, 5, 1e-6);
}

}  // namespace
}  // namespace blossom::occt
