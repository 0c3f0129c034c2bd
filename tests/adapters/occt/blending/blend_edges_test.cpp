// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/blend_edges.h"

#include <gtest/gtest.h>

#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Dir2d.hxx>
#include <gp_Pnt2d.hxx>

namespace blossom::occt {
namespace {

constexpr int kSpans = 256;

// A polygon on the line from 0 to 256 in x, with one corner off it.
Handle(Geom_BSplineCurve) bent_line(int corner, double height) {
  TColgp_Array1OfPnt poles(0, kSpans);
  TColStd_Array1OfReal knots(0, kSpans);
  TColStd_Array1OfInteger multiplicities(0, kSpans);
  for (int i = 0; i <= kSpans; ++i) {
    poles(i) = gp_Pnt(i, 0, i == corner ? height : 0);
    knots(i) = i;
    multiplicities(i) = i == 0 || i == kSpans ? 2 : 1;
  }
  return new Geom_BSplineCurve(poles, knots, multiplicities, 1);
}

TEST(EdgeTolerance, CoversWhatCurvesAreApartInASingleSpan) {
  const TopoDS_Face plane = plane_face({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  for (const int corner : {1, 130, 202}) {
    const TopoDS_Edge edge = edge_on(bent_line(corner, 1e-4), {0, kSpans}, vertex_at({0, 0, 0}),
                                     vertex_at({kSpans, 0, 0}));
    add_chart(edge, new Geom2d_Line(gp_Pnt2d(0, 0), gp_Dir2d(1, 0)), plane);
    EXPECT_GE(BRep_Tool::Tolerance(edge), 1e-4) << corner;
    EXPECT_LE(BRep_Tool::Tolerance(edge), 1.2e-4) << corner;
  }
}

}  // namespace
}  // namespace blossom::occt
