// SPDX-License-Identifier: LGPL-2.1-or-later
// Curves of edges in the parameters of faces are those that Open CASCADE has or makes.
#include "adapters/occt/convert/edge_charts.h"
#include "tests/support/measures.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Plane.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Circ.hxx>
#include <gp_Elips.hxx>

namespace blossom::occt {
namespace {

using testing::kPi;

// Of all edges of a shape of faces; their number.
int expect_as_occt_has_them(const TopoDS_Shape& shape) {
  int count = 0;
  for (TopExp_Explorer of(shape, TopAbs_FACE); of.More(); of.Next())
    for (TopExp_Explorer it(of.Current(), TopAbs_EDGE); it.More(); it.Next(), ++count) {
      const TopoDS_Face face = TopoDS::Face(of.Current());
      const TopoDS_Edge edge = TopoDS::Edge(it.Current());
      Interval range, theirs;
      const Handle(Geom2d_Curve) curve = chart_curve_of(edge, face, range);
      const Handle(Geom2d_Curve) known =
          BRep_Tool::CurveOnSurface(edge, face, theirs.from, theirs.to);
      EXPECT_FALSE(curve.IsNull());
      if (curve.IsNull()) continue;
      EXPECT_EQ(range.from, theirs.from);
      EXPECT_EQ(range.to, theirs.to);
      for (const double part : {0.0, 0.3, 0.7, 1.0}) {
        const double t = at(range, part);
        EXPECT_LT(curve->Value(t).Distance(known->Value(t)), 1e-12);
      }
    }
  return count;
}

// Half a disc, half an ellipse and lines on a plane, whose edges have no curves in its parameters.
TopoDS_Face outline_on(const gp_Ax3& place) {
  const auto at = [&](double x, double y) {
    return place.Location().Translated(gp_Vec(place.XDirection()) * x +
                                       gp_Vec(place.YDirection()) * y);
  };
  const gp_Ax2 upper(at(2, 1), place.XDirection() ^ place.YDirection(), place.XDirection());
  const gp_Ax2 right(at(3, 0.5), place.YDirection() ^ place.XDirection(), -place.YDirection());
  BRepBuilderAPI_MakeWire wire(
      BRepBuilderAPI_MakeEdge(at(1, 0), at(3, 0)).Edge(),
      BRepBuilderAPI_MakeEdge(gp_Elips(right, 0.5, 0.25), at(3, 0), at(3, 1)).Edge(),
      BRepBuilderAPI_MakeEdge(gp_Circ(upper, 1), at(3, 1), at(1, 1)).Edge(),
      BRepBuilderAPI_MakeEdge(at(1, 1), at(1, 0)).Edge());
  return BRepBuilderAPI_MakeFace(new Geom_Plane(place), wire.Wire());
}

TEST(EdgeCharts, OfPlanesAreThoseThatOpenCascadeProjects) {
  const gp_Ax3 place(gp_Pnt(3, -2, 5), gp_Dir(1, 2, 3), gp_Dir(3, 0, -1));
  gp_Ax3 left_handed = place;
  left_handed.YReverse();
  EXPECT_EQ(expect_as_occt_has_them(outline_on(gp_Ax3())), 4);
  EXPECT_EQ(expect_as_occt_has_them(outline_on(place)), 4);
  EXPECT_EQ(expect_as_occt_has_them(outline_on(left_handed)), 4);
  EXPECT_EQ(expect_as_occt_has_them(outline_on(place).Reversed()), 4);
}

TEST(EdgeCharts, FollowTheFaceWhereItIsPlaced) {
  gp_Trsf turn, mirror;
  turn.SetRotation(gp_Ax1(gp_Pnt(1, 1, 1), gp_Dir(1, 1, 0.5)), 1.2);
  mirror.SetMirror(gp_Ax2(gp_Pnt(0, 1, 0), gp_Dir(1, 0, 2)));
  const TopoDS_Face face = outline_on(gp_Ax3(gp_Pnt(0, 0, 7), gp_Dir(1, 0, 1)));
  EXPECT_EQ(expect_as_occt_has_them(face.Moved(turn)), 4);
  EXPECT_EQ(expect_as_occt_has_them(face.Moved(mirror, Standard_False)), 4);
}

// An edge that has a place of its own in the face.
TEST(EdgeCharts, FollowAnEdgeThatIsPlacedInTheFace) {
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 0.4);
  const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp_Pnt(2, 0, 0), gp::DZ()), 1));
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(
      new Geom_Plane(gp_Ax3()), BRepBuilderAPI_MakeWire(TopoDS::Edge(edge.Moved(turn))).Wire());
  EXPECT_EQ(expect_as_occt_has_them(face), 1);
}

TEST(EdgeCharts, OfOtherSurfacesAndCurvesAreOpenCascadesOwn) {
  EXPECT_EQ(expect_as_occt_has_them(BRepPrimAPI_MakeCylinder(2, 3, kPi).Shape()), 18);
  TColgp_Array1OfPnt poles(1, 3);
  poles(1) = {1, 0, 0};
  poles(2) = {2, 1, 0};
  poles(3) = {3, 0, 0};
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(
      new Geom_Plane(gp_Ax3()),
      BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Pnt(1, 0, 0), gp_Pnt(3, 0, 0)).Edge(),
                              BRepBuilderAPI_MakeEdge(new Geom_BezierCurve(poles)).Edge())
          .Wire());
  EXPECT_EQ(expect_as_occt_has_them(face), 2);
}

// Of the two curves of a seam the one that the face's turn asks for.
TEST(EdgeCharts, OfSeamsFollowTheTurnOfTheFace) {
  const TopoDS_Shape rod = BRepPrimAPI_MakeCylinder(2, 3).Shape();
  EXPECT_EQ(expect_as_occt_has_them(rod), 6);
  EXPECT_EQ(expect_as_occt_has_them(rod.Reversed()), 6);
}

// What leaves the plane is not taken for something in it.
TEST(EdgeCharts, OfEdgesThatLeaveThePlaneAreOpenCascadesOwn) {
  TopoDS_Face face = outline_on(gp_Ax3());
  TopoDS_Wire wire;
  const BRep_Builder builder;
  builder.MakeWire(wire);
  builder.Add(wire, BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(1, 0, 1)).Edge());
  builder.Add(face, wire);
  EXPECT_EQ(expect_as_occt_has_them(face), 5);
}

}  // namespace
}  // namespace blossom::occt
