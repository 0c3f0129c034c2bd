// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/repair/closed_corners.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>

namespace blossom::occt {
namespace {

constexpr double kGap = 1e-4;

TopTools_IndexedMapOfShape edges_of(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  return edges;
}

// The shape with the curve of its first edge moved by the gap.
TopoDS_Shape loosened(const TopoDS_Shape& shape, double tolerance) {
  const TopoDS_Edge edge = TopoDS::Edge(edges_of(shape)(1));
  double first = 0, last = 0;
  const Handle(Geom_Curve) moved = Handle(Geom_Curve)::DownCast(
      BRep_Tool::Curve(edge, first, last)->Translated(gp_Vec(kGap, kGap, kGap)));
  BRep_Builder().UpdateEdge(edge, moved, tolerance);
  for (const TopoDS_Vertex& vertex : {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)})
    BRep_Builder().UpdateVertex(vertex, tolerance);
  return shape;
}

TopoDS_Shape spline_box() {
  return BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), true).Shape();
}

// The farthest that curves end from each other in one vertex.
double largest_gap(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape vertices;
  std::map<int, gp_Pnt> known;
  double largest = 0;
  const TopTools_IndexedMapOfShape edges = edges_of(shape);
  for (int i = 1; i <= edges.Extent(); ++i) {
    const TopoDS_Edge edge = TopoDS::Edge(edges(i).Oriented(TopAbs_FORWARD));
    double first = 0, last = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
    for (const bool end : {false, true}) {
      const gp_Pnt point = curve->Value(end ? last : first);
      const int vertex = vertices.Add(end ? TopExp::LastVertex(edge) : TopExp::FirstVertex(edge));
      largest = std::max(largest, known.emplace(vertex, point).first->second.Distance(point));
    }
  }
  return largest;
}

TEST(ClosedCorners, HaveCurvesThatEndInOnePointForAsLongAsTheyLive) {
  const TopoDS_Shape box = loosened(spline_box(), 1e-3);
  const TopoDS_Edge edge = TopoDS::Edge(edges_of(box)(1));
  double first = 0, last = 0;
  const Handle(Geom_Curve) given = BRep_Tool::Curve(edge, first, last);
  ASSERT_GT(largest_gap(box), kGap);
  {
    const ClosedCorners closed(box);
    EXPECT_EQ(closed.count(), 6u);  // three curves at each end of the loose one
    EXPECT_LE(largest_gap(box), 1e-12);
    const Handle(Geom_Curve) bent = BRep_Tool::Curve(edge, first, last);
    for (const double part : {0.01, 0.3, 0.5, 0.99}) {
      const double t = first + part * (last - first);
      EXPECT_LE(bent->Value(t).Distance(given->Value(t)), 1e-12) << part;
    }
    EXPECT_LE(bent->Value(first).Distance(given->Value(first)), 2 * kGap);
  }
  EXPECT_EQ(BRep_Tool::Curve(edge, first, last), given);
}

TEST(ClosedCorners, LeaveWhatMeetsAndWhatNoToleranceAllows) {
  EXPECT_EQ(ClosedCorners(spline_box()).count(), 0u);
  EXPECT_EQ(ClosedCorners(loosened(spline_box(), 1e-5)).count(), 0u);
}

TEST(ClosedCorners, LeaveLinesAndCirclesWhatTheyAre) {
  EXPECT_EQ(ClosedCorners(loosened(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), 1e-3)).count(), 0u);
  EXPECT_EQ(ClosedCorners(BRepPrimAPI_MakeCylinder(1, 2).Shape()).count(), 0u);
}

// As a spline a Bezier curve over a part of its range has other parameters than its edge.
TEST(ClosedCorners, LeaveCurvesThatDoNotKeepTheirParameters) {
  const TopoDS_Shape box = loosened(spline_box(), 1e-3);
  const TopoDS_Edge edge = TopoDS::Edge(edges_of(box)(1));
  double first = 0, last = 0;
  const Handle(Geom_Curve) line = BRep_Tool::Curve(edge, first, last);
  const gp_XYZ from = line->Value(first).XYZ(), rate = (line->Value(last).XYZ() - from) / 0.5;
  TColgp_Array1OfPnt poles(1, 2);
  poles(1) = from - 0.2 * rate;
  poles(2) = from + 0.8 * rate;
  const Handle(Geom_Curve) given = new Geom_BezierCurve(poles);
  BRep_Builder().UpdateEdge(edge, given, 1e-3);
  BRep_Builder().Range(edge, 0.2, 0.7);

  const ClosedCorners closed(box);

  EXPECT_EQ(closed.count(), 4u);  // the two others at each of its ends
  EXPECT_LE(closed.worst(), 2 * kGap);
  EXPECT_EQ(BRep_Tool::Curve(edge, first, last), given);
}

}  // namespace
}  // namespace blossom::occt
