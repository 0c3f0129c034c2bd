// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/own_copy.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>

#include "adapters/occt/faces/area.h"

namespace blossom::occt {
namespace {

TopoDS_Shape moved_bored_box() {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 8, 6).Shape();
  const TopoDS_Shape bore = BRepPrimAPI_MakeCylinder(gp_Ax2({5, 4, -1}, {0, 0, 1}), 2, 9).Shape();
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1({1, 2, 3}, {1, 1, 0}), 0.7);
  return BRepAlgoAPI_Cut(box, bore).Shape().Moved(turn).Reversed();
}

TEST(OwnCopy, KeepsNumbersPlacesAndCurves) {
  const TopoDS_Shape shape = moved_bored_box(), copy = own_copy(shape);
  EXPECT_TRUE(BRepCheck_Analyzer(copy).IsValid());
  for (const TopAbs_ShapeEnum kind : {TopAbs_FACE, TopAbs_WIRE, TopAbs_EDGE, TopAbs_VERTEX}) {
    TopTools_IndexedMapOfShape before, after;
    TopExp::MapShapes(shape, kind, before);
    TopExp::MapShapes(copy, kind, after);
    ASSERT_EQ(before.Extent(), after.Extent());
    for (int i = 1; i <= before.Extent(); ++i) {
      EXPECT_FALSE(before(i).IsPartner(after(i)));
      EXPECT_EQ(before(i).Orientation(), after(i).Orientation());
      EXPECT_TRUE(before(i).Location() == after(i).Location());
      EXPECT_EQ(before(i).Closed(), after(i).Closed());
      if (kind == TopAbs_VERTEX) {
        EXPECT_EQ(BRep_Tool::Pnt(TopoDS::Vertex(before(i)))
                      .Distance(BRep_Tool::Pnt(TopoDS::Vertex(after(i)))),
                  0);
      }
      if (kind != TopAbs_FACE) continue;
      const TopoDS_Face &a = TopoDS::Face(before(i)), &b = TopoDS::Face(after(i));
      TopLoc_Location of_a, of_b;
      EXPECT_TRUE(BRep_Tool::Surface(a, of_a) == BRep_Tool::Surface(b, of_b));
      EXPECT_EQ(cone_volume(a, {1, 1, 1}), cone_volume(b, {1, 1, 1}));
    }
  }
}

TEST(OwnCopy, IsChangedWithoutTheShape) {
  const TopoDS_Shape shape = moved_bored_box(), copy = own_copy(shape);
  TopTools_IndexedMapOfShape before, after;
  TopExp::MapShapes(shape, TopAbs_EDGE, before);
  TopExp::MapShapes(copy, TopAbs_EDGE, after);
  BRep_Builder().UpdateEdge(TopoDS::Edge(after(1)), 0.5);
  EXPECT_LT(BRep_Tool::Tolerance(TopoDS::Edge(before(1))), 0.1);
  EXPECT_EQ(BRep_Tool::Tolerance(TopoDS::Edge(after(1))), 0.5);
}

// A trapezoid, wherever it is: rounding does not decide whether it is flat.
TEST(OwnCopy, IsFlattenedWhereSplinesArePlanes) {
  for (const double place : {0.0, 0.1, 17.3, 120.0, 300.0})
    for (const double off : {0.0, 1e-7}) {
      TColgp_Array2OfPnt poles(1, 2, 1, 2);
      poles(1, 1) = {place, 0, 0};
      poles(2, 1) = {place + 60, 0, 0};
      poles(1, 2) = {place + 2.1, 2.1, 30};
      poles(2, 2) = {place + 57.9, 2.1, 30 + off};
      const Handle(Geom_BezierSurface) surface = new Geom_BezierSurface(poles);
      for (const bool turned : {false, true}) {
        gp_Trsf turn;
        if (turned) turn.SetRotation(gp_Ax1({1, 2, 3}, {3, -1, 2}), 0.7);
        const auto moved = Handle(Geom_Surface)::DownCast(surface->Transformed(turn));
        const TopoDS_Shape copy = own_copy(BRepBuilderAPI_MakeFace(moved, 1e-7).Face());
        flatten(copy);
        const bool is_flat = BRep_Tool::Surface(TopoDS::Face(copy))->IsKind("Geom_Plane");
        EXPECT_EQ(is_flat, off == 0) << place << (turned ? ", turned" : "");
      }
    }
}

}  // namespace
}  // namespace blossom::occt
