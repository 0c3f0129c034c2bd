// SPDX-License-Identifier: LGPL-2.1-or-later
// What is proven of faces between straight edges is so by BRepCheck, too.
#include "adapters/occt/solids/validity/polygon_faces.h"

#include <gtest/gtest.h>

#include <vector>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Plane.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax3.hxx>
#include <gp_Trsf.hxx>

namespace blossom::occt {
namespace {

using Points = std::vector<gp_Pnt2d>;

const gp_Ax3 kAxes(gp_Pnt(1, 2, 3), gp_Dir(1, 2, 2), gp_Dir(2, -2, 1));

gp_Pnt in_space(const gp_Pnt2d& p) {
  return kAxes.Location()
      .Translated(gp_Vec(kAxes.XDirection()) * p.X())
      .Translated(gp_Vec(kAxes.YDirection()) * p.Y());
}

TopoDS_Wire wire_of(const Points& points) {
  BRepBuilderAPI_MakePolygon polygon;
  for (const gp_Pnt2d& p : points) polygon.Add(in_space(p));
  polygon.Close();
  return polygon.Wire();
}

// As the wires are: nothing is turned or mended.
TopoDS_Face face_of(const std::vector<Points>& rings) {
  const BRep_Builder builder;
  TopoDS_Face face;
  builder.MakeFace(face, new Geom_Plane(kAxes), 1e-7);
  for (const Points& ring : rings) builder.Add(face, wire_of(ring));
  return face;
}

const Points kSquare{{0, 0}, {4, 0}, {4, 4}, {0, 4}};

Points hole(double x, double y, double size) {
  return {{x, y}, {x, y + size}, {x + size, y + size}, {x + size, y}};
}

void expect_sound(const TopoDS_Face& face) {
  EXPECT_TRUE(BRepCheck_Analyzer(face).IsValid());
  EXPECT_TRUE(is_sound_polygon(face));
}

void expect_unsound(const TopoDS_Face& face) {
  EXPECT_FALSE(BRepCheck_Analyzer(face).IsValid());
  EXPECT_FALSE(is_sound_polygon(face));
}

TopoDS_Edge first_edge(const TopoDS_Face& face) {
  return TopoDS::Edge(TopExp_Explorer(face, TopAbs_EDGE).Current());
}

TEST(PolygonFaces, AreProvenWithHolesTurnedAndMoved) {
  const TopoDS_Face face = face_of({hole(1, 1, 0.5), kSquare, hole(2, 2, 1)});
  expect_sound(face);
  expect_sound(TopoDS::Face(face.Reversed()));
  gp_Trsf move;
  move.SetRotation(gp_Ax1({3, 2, 1}, gp_Dir(1, 1, 0)), 0.7);
  expect_sound(TopoDS::Face(face.Moved(move)));
  expect_sound(face_of({{{0, 0}, {2, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}}}));
  for (TopExp_Explorer it(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), TopAbs_FACE); it.More(); it.Next())
    expect_sound(TopoDS::Face(it.Current()));
}

TEST(PolygonFaces, WithRingsThatCrossOrNestAreNot) {
  expect_unsound(face_of({{{0, 0}, {4, 0}, {0, 4}, {4, 5}}}));
  expect_unsound(face_of({kSquare, hole(3, 3, 2)}));
  expect_unsound(face_of({kSquare, hole(5, 1, 1)}));
  expect_unsound(face_of({kSquare, hole(1, 1, 2), hole(1.5, 1.5, 1)}));
  expect_unsound(face_of({hole(1, 1, 2)}));
  const Points turned{{1, 1}, {2, 1}, {2, 2}, {1, 2}};
  expect_unsound(face_of({kSquare, turned}));
  expect_unsound(face_of({turned, kSquare}));
}

TEST(PolygonFaces, OpenWiresAreNot) {
  const BRep_Builder builder;
  TopoDS_Face face;
  builder.MakeFace(face, new Geom_Plane(kAxes), 1e-7);
  BRepBuilderAPI_MakePolygon open;
  for (const gp_Pnt2d& p : kSquare) open.Add(in_space(p));
  builder.Add(face, open.Wire());
  EXPECT_FALSE(is_sound_polygon(face));

  // One that ends where it starts, but in a vertex of its own.
  TopoDS_Face doubled;
  builder.MakeFace(doubled, new Geom_Plane(kAxes), 1e-7);
  const auto vertex_at = [](const gp_Pnt2d& p) {
    return BRepBuilderAPI_MakeVertex(in_space(p)).Vertex();
  };
  BRepBuilderAPI_MakePolygon apart;
  for (const gp_Pnt2d& p : kSquare) apart.Add(vertex_at(p));
  TopoDS_Wire wire = apart.Wire();
  const TopoDS_Edge last =
      BRepBuilderAPI_MakeEdge(apart.LastVertex(), vertex_at(kSquare.front())).Edge();
  builder.Add(wire, last);
  builder.Add(doubled, wire);
  EXPECT_FALSE(is_sound_polygon(doubled));
}

TEST(PolygonFaces, OffTheirVerticesPlaneOrCurvesAreNot) {
  const BRep_Builder builder;
  const TopoDS_Face vertex_off = face_of({kSquare});
  const TopoDS_Vertex vertex = TopoDS::Vertex(TopExp_Explorer(vertex_off, TopAbs_VERTEX).Current());
  builder.UpdateVertex(vertex, BRep_Tool::Pnt(vertex).Translated({2e-7, 0, 0}), 1e-7);
  expect_unsound(vertex_off);

  TopoDS_Face plane_off;
  builder.MakeFace(plane_off, new Geom_Plane(kAxes.Translated(gp_Vec(kAxes.Direction()) * 1e-5)),
                   1e-7);
  builder.Add(plane_off, wire_of(kSquare));
  EXPECT_FALSE(is_sound_polygon(plane_off));

  for (const double shift : {0.0, 1e-5}) {
    const TopoDS_Face stored = face_of({kSquare});
    TopLoc_Location place;
    const Handle(Geom_Surface) plane = BRep_Tool::Surface(stored, place);
    builder.UpdateEdge(first_edge(stored), new Geom2d_Line({0, shift}, {1, 0}), plane, place, 1e-7);
    if (shift == 0)
      expect_sound(stored);
    else
      expect_unsound(stored);
  }
}

void set_vertex_tolerances(const TopoDS_Face& face, double tolerance) {
  for (TopExp_Explorer it(face, TopAbs_VERTEX); it.More(); it.Next())
    BRep_Builder().UpdateVertex(TopoDS::Vertex(it.Current()), tolerance);
}

// The first edge's line moved in space, along directions of the axes.
void move_first_edge(const TopoDS_Face& face, const gp_Vec& by, double tolerance) {
  const TopoDS_Edge edge = first_edge(face);
  double from = 0, to = 0;
  const auto line = Handle(Geom_Curve)::DownCast(BRep_Tool::Curve(edge, from, to)->Translated(by));
  BRep_Builder().UpdateEdge(edge, line, tolerance);
}

// A large tolerance of the vertices does not excuse a curve, nor one of an edge its vertices.
TEST(PolygonFaces, AreHeldByEachToleranceOfItsOwn) {
  const TopoDS_Face chart_off = face_of({kSquare});
  set_vertex_tolerances(chart_off, 1e-3);
  expect_sound(chart_off);
  TopLoc_Location place;
  const Handle(Geom_Surface) plane = BRep_Tool::Surface(chart_off, place);
  BRep_Builder().UpdateEdge(first_edge(chart_off), new Geom2d_Line({0, 1e-5}, {1, 0}), plane, place,
                            1e-7);
  expect_unsound(chart_off);
  EXPECT_FALSE(is_held_polygon(chart_off));

  const TopoDS_Face line_off = face_of({kSquare});
  move_first_edge(line_off, gp_Vec(kAxes.Direction()) * 1e-5, 1e-3);
  EXPECT_FALSE(is_sound_polygon(line_off));
}

// At an acute corner sides a gap apart cross farther away than the gap.
TEST(PolygonFaces, WithSidesThatCrossNearAnAcuteCornerAreNot) {
  const TopoDS_Face face = face_of({{{0, 0}, {4, 0}, {4, 0.2}}});
  set_vertex_tolerances(face, 1e-5);
  expect_sound(face);
  move_first_edge(face, gp_Vec(kAxes.YDirection()) * 1e-6, 1e-7);
  EXPECT_FALSE(is_sound_polygon(face));
}

TEST(PolygonFaces, OfOtherCurvesAndSurfacesNothingIsSaid) {
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(1, 2).Shape();
  for (TopExp_Explorer it(cylinder, TopAbs_FACE); it.More(); it.Next())
    EXPECT_FALSE(is_held_polygon(TopoDS::Face(it.Current())));
}

// A spike's sides part only slowly, and edges that touch are left to BRepCheck.
TEST(PolygonFaces, InDoubtNothingIsSaid) {
  for (const TopoDS_Face& face :
       {face_of({{{0, 0}, {4, 0}, {4, 1e-2}}}), face_of({kSquare, hole(1, 1, 1), hole(1, 2, 1)})}) {
    EXPECT_TRUE(is_held_polygon(face));
    EXPECT_FALSE(is_sound_polygon(face));
  }
}

}  // namespace
}  // namespace blossom::occt
