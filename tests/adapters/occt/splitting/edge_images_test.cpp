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
#include <Geom_BezierSurface.hxx>
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

}  // namespace
}  // namespace blossom::occt
