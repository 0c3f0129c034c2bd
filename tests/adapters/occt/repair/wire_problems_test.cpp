// SPDX-License-Identifier: LGPL-2.1-or-later
// Wires that meet themselves, and those that only do so within a vertex.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <gp.hxx>
#include <gp_Ax2.hxx>
#include <gp_Dir.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/soundness.h"

namespace blossom::occt {
namespace {

TopoDS_Edge line(const gp_Pnt& from, const gp_Pnt& to, const TopoDS_Vertex& first,
                 const TopoDS_Vertex& last) {
  const BRep_Builder builder;
  TopoDS_Edge edge;
  builder.MakeEdge(edge, new Geom_Line(from, gp_Dir(gp_Vec(from, to))), Precision::Confusion());
  builder.Range(edge, 0, from.Distance(to));
  builder.Add(edge, first.Oriented(TopAbs_FORWARD));
  builder.Add(edge, last.Oriented(TopAbs_REVERSED));
  return edge;
}

// The second edge misses the end of the first one by 1e-5 and goes over it 5e-4 before.
TopoDS_Face with_a_miss(double tolerance) {
  const BRep_Builder builder;
  const std::array points{gp_Pnt(0, 0, 0), gp_Pnt(1, 0, 0), gp_Pnt(0.5, 0.01, 0),
                          gp_Pnt(0, 0.5, 0)};
  std::array<TopoDS_Vertex, 4> vertices;
  for (std::size_t i = 0; i < 4; ++i)
    builder.MakeVertex(vertices[i], points[i], i == 1 ? tolerance : Precision::Confusion());
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  builder.Add(wire, line(points[0], points[1], vertices[0], vertices[1]));
  builder.Add(wire, line(gp_Pnt(1, -1e-5, 0), points[2], vertices[1], vertices[2]));
  builder.Add(wire, line(points[2], points[3], vertices[2], vertices[3]));
  builder.Add(wire, line(points[3], points[0], vertices[3], vertices[0]));
  wire.Closed(Standard_True);
  TopoDS_Face face;
  builder.MakeFace(face, new Geom_Plane(gp_Pln()), Precision::Confusion());
  builder.Add(face, wire);
  return face;
}

TEST(WireProblems, AreNoneWhereEdgesCrossWithinTheirVertex) {
  EXPECT_TRUE(wire_problems(with_a_miss(1e-3)).empty());
}

TEST(WireProblems, AreToldWhereEdgesCrossOutsideOfTheirVertex) {
  const auto problems = wire_problems(with_a_miss(1e-4));
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems.front().what, "a wire meets itself");
}

// A triangular hole with a corner on that of the square, as one vertex or as two.
TopoDS_Face with_a_hole_in_its_corner(bool shared) {
  const BRep_Builder builder;
  const std::array points{gp_Pnt(0, 0, 0), gp_Pnt(4, 0, 0), gp_Pnt(4, 4, 0), gp_Pnt(0, 4, 0),
                          gp_Pnt(0, 0, 0), gp_Pnt(1, 2, 0), gp_Pnt(2, 1, 0)};
  std::array<TopoDS_Vertex, 7> vertices;
  for (std::size_t i = 0; i < 7; ++i)
    builder.MakeVertex(vertices[i], points[i], Precision::Confusion());
  if (shared) vertices[4] = vertices[0];
  TopoDS_Face face;
  builder.MakeFace(face, new Geom_Plane(gp_Pln()), Precision::Confusion());
  for (const auto& [first, count] : {std::pair<std::size_t, std::size_t>{0, 4}, {4, 3}}) {
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t from = first + k, to = first + (k + 1) % count;
      builder.Add(wire, line(points[from], points[to], vertices[from], vertices[to]));
    }
    wire.Closed(Standard_True);
    builder.Add(face, wire);
  }
  return face;
}

TEST(WireProblems, AreNoneWhereWiresTouchInOneVertex) {
  EXPECT_TRUE(wire_problems(with_a_hole_in_its_corner(true)).empty());
  EXPECT_FALSE(wire_problems(with_a_hole_in_its_corner(false)).empty());
}

// An arc of radius 1 and its tangent, turned by 2e-5: they cross 4e-5 from their corner, between
// which they are 1e-10 apart; turned by 2e-2 they cross 4e-2 away, 1e-4 apart.
TopoDS_Face with_a_tangent(double turn) {
  const BRep_Builder builder;
  const gp_Pnt corner(0, 0, 0), end(std::cos(turn), std::sin(turn), 0), top(1, 1, 0);
  std::array<TopoDS_Vertex, 3> vertices;
  builder.MakeVertex(vertices[0], corner, Precision::Confusion());
  builder.MakeVertex(vertices[1], end, Precision::Confusion());
  builder.MakeVertex(vertices[2], top, Precision::Confusion());
  TopoDS_Edge arc;
  builder.MakeEdge(arc, new Geom_Circle(gp_Ax2(gp_Pnt(0, 1, 0), gp::DZ(), -gp::DY()), 1),
                   Precision::Confusion());
  builder.Range(arc, 0, 0.5 * std::numbers::pi);
  builder.Add(arc, vertices[0].Oriented(TopAbs_FORWARD));
  builder.Add(arc, vertices[2].Oriented(TopAbs_REVERSED));
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  builder.Add(wire, line(corner, end, vertices[0], vertices[1]));
  builder.Add(wire, line(end, top, vertices[1], vertices[2]));
  builder.Add(wire, arc.Reversed());
  wire.Closed(Standard_True);
  TopoDS_Face face;
  builder.MakeFace(face, new Geom_Plane(gp_Pln()), Precision::Confusion());
  builder.Add(face, wire);
  return face;
}

// Ends in the origin, turned about it.
TopoDS_Edge circle(double radius, double turn, const TopoDS_Vertex& end) {
  const BRep_Builder builder;
  const gp_Dir out(std::cos(turn), std::sin(turn), 0);
  TopoDS_Edge edge;
  builder.MakeEdge(edge,
                   new Geom_Circle(gp_Ax2(gp_Pnt(-radius * out.XYZ()), gp::DZ(), out), radius),
                   Precision::Confusion());
  builder.Range(edge, 0, 2 * std::numbers::pi);
  builder.Add(edge, end.Oriented(TopAbs_FORWARD));
  builder.Add(edge, end.Oriented(TopAbs_REVERSED));
  return edge;
}

// The part of a disc of radius 1 outside of one of radius 1/2 that touches its rim from inside, in
// a vertex of both. Turned by 3e-4 it crosses the rim 6e-4 from there, between which they are
// 5e-8 apart; turned by 2e-2 4e-2 away, 2e-4 apart.
TopoDS_Face crescent(double turn) {
  const BRep_Builder builder;
  TopoDS_Vertex touch;
  builder.MakeVertex(touch, gp_Pnt(0, 0, 0), Precision::Confusion());
  TopoDS_Face face;
  builder.MakeFace(face, new Geom_Plane(gp_Pln()), Precision::Confusion());
  for (const TopoDS_Edge& edge :
       {circle(1, 0, touch), TopoDS::Edge(circle(0.5, turn, touch).Reversed())}) {
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    builder.Add(wire, edge);
    wire.Closed(Standard_True);
    builder.Add(face, wire);
  }
  return face;
}

TEST(WireProblems, AreNoneWhereWiresTouchInTheirVertexWithinTolerance) {
  EXPECT_TRUE(wire_problems(crescent(0)).empty());
  EXPECT_TRUE(wire_problems(crescent(3e-4)).empty());
  EXPECT_FALSE(wire_problems(crescent(2e-2)).empty());
}

TEST(WireProblems, AreNoneWhereATangentCrossesItsArcWithinTolerance) {
  EXPECT_TRUE(wire_problems(with_a_tangent(2e-5)).empty());
  EXPECT_EQ(wire_problems(with_a_tangent(2e-2)).size(), 1U);
}

// Of a result of a boolean: a sliver of a torus in which two edges cross 3e-4 from the corner that
// they share, and are within 3e-8 of each other from there on, and for a while beyond.
TEST(WireProblems, AreNoneInASliverOfTangentSurfaces) {
  TopoDS_Shape face;
  ASSERT_TRUE(BRepTools::Read(face, BLOSSOM_TEST_FILES "/faces/touching_arc.brep", BRep_Builder()));
  EXPECT_TRUE(wire_problems(TopoDS::Face(face)).empty());
}

}  // namespace
}  // namespace blossom::occt
