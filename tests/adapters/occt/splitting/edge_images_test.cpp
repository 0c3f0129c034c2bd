// SPDX-License-Identifier: LGPL-2.1-or-later
// Edges as cuts of a face that they end in.

#include "adapters/occt/splitting/edge_images.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Circle.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>

namespace blossom::occt {
namespace {

constexpr double kFullTurn = 2 * std::numbers::pi;

// 6 x 4, flat, and no plane.
Handle(Geom_Surface) flat_patch() {
  TColgp_Array2OfPnt poles(1, 2, 1, 2);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) poles(i + 1, j + 1) = gp_Pnt(6 * i, 4 * j, 0);
  return new Geom_BezierSurface(poles);
}

// The arc ends in the border of the patch, a few roundings past it: what of it is on the patch has
// its joint where it crosses the border, which is nearer to its end than numbers lie.
TEST(EdgeCuts, AreOfNumbersWhereAnEdgeEndsInTheBorderOfASurface) {
  const gp_Circ circle(gp_Ax2({4, 0, 0}, gp::DZ()), 1);
  const TopoDS_Edge arc = BRepBuilderAPI_MakeEdge(circle, 0.75 * kFullTurn, kFullTurn).Edge();
  BRepBuilderAPI_MakeWire wire(arc);
  wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(5, 0, 0), gp_Pnt(4, 0, 0)).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(4, 0, 0), gp_Pnt(4, -1, 0)).Edge());
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(wire.Wire()).Face();
  const SurfaceProjector feet(BRepBuilderAPI_MakeFace(flat_patch(), 1e-7).Face(), 1e-7);
  const std::vector<FaceCut> cuts = edge_cuts(face, feet, 1e-7, 1e-7);
  ASSERT_FALSE(cuts.empty());
  for (const FaceCut& cut : cuts) {
    for (std::size_t i = 0; i + 1 < cut.chart.knots.size(); ++i)
      EXPECT_LT(cut.chart.knots[i], cut.chart.knots[i + 1]);
    for (const Vec2& uv : cut.chart.points)
      EXPECT_TRUE(std::isfinite(uv[0]) && std::isfinite(uv[1]));
  }
}

// Comes down to the patch, lies on it for t in [1, 2], and goes up again.
Handle(Geom_Curve) landing() {
  TColgp_Array1OfPnt poles(1, 4);
  poles(1) = gp_Pnt(1, 1, 5);
  poles(2) = gp_Pnt(2, 1, 0);
  poles(3) = gp_Pnt(4, 1, 0);
  poles(4) = gp_Pnt(5, 1, 5);
  TColStd_Array1OfReal knots(1, 4);
  TColStd_Array1OfInteger multiplicities(1, 4);
  for (int i = 1; i <= 4; ++i) {
    knots(i) = i - 1;
    multiplicities(i) = i == 1 || i == 4 ? 2 : 1;
  }
  return new Geom_BSplineCurve(poles, knots, multiplicities, 1);
}

TEST(CurvesBesideSurfaces, RunOnThemBetweenPlacesFarOff) {
  const SurfaceProjector feet(BRepBuilderAPI_MakeFace(flat_patch(), 1e-7).Face(), 1e-7);
  const CurveBeside all(landing(), {0, 3}, feet);
  const std::vector<Interval> runs = all.runs(1e-7, 1e-7);
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_NEAR(runs[0].from, 1, 1e-7);
  EXPECT_NEAR(runs[0].to, 2, 1e-7);
  EXPECT_FALSE(all.is_one_run(1e-7, 1e-7));
  EXPECT_TRUE(CurveBeside(landing(), {1.25, 1.75}, feet).is_one_run(1e-7, 1e-7));
  EXPECT_FALSE(CurveBeside(landing(), {1.25, 2.75}, feet).is_one_run(1e-7, 1e-7));
  EXPECT_TRUE(CurveBeside(landing(), {2.25, 2.75}, feet).runs(1e-7, 1e-7).empty());
  // Both ends are on the patch, what lies between them is not.
  const Handle(Geom_Curve) arch = new Geom_Circle(gp_Ax2({3, 2, 0}, gp::DY()), 2);
  EXPECT_FALSE(CurveBeside(arch, {0, 0.5 * kFullTurn}, feet).is_one_run(1e-7, 1e-7));
}

}  // namespace
}  // namespace blossom::occt
