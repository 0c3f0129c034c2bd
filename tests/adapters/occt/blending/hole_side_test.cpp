// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/hole_side.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Precision.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TopoDS.hxx>
#include <gp_Cylinder.hxx>

namespace blossom::occt {
namespace {

// A path that turns sharply is slow where it does, and the direction across it turns fast there.
// Both together are as smooth as the path itself.
TEST(HoleSide, IsFollowedRoundASharpTurn) {
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(gp_Cylinder(gp::XOY(), 10), 0, 1, 0, 10).Face();
  TColgp_Array1OfPnt2d poles(1, 4);
  poles(1) = {0.2, 2};
  poles(2) = {0.34, 2};
  poles(3) = {0.3, 1.6};
  poles(4) = {0.3, 3};
  TopoDS_Edge edge;
  const BRep_Builder builder;
  builder.MakeEdge(edge);
  builder.UpdateEdge(edge, new Geom2d_BezierCurve(poles), face, Precision::Confusion());
  builder.Range(edge, 0, 1);

  const HoleSide made = hole_side({1, edge, face, false}, FillContinuity::G1, {});

  EXPECT_LE(made.error, FitTolerance{}.point);
  EXPECT_LE(made.angle_error, FitTolerance{}.angle);
}

}  // namespace
}  // namespace blossom::occt
