// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/sheet/face_borders.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <Geom_Line.hxx>
#include <TopoDS.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/blending/body_edges.h"

namespace blossom::occt {
namespace {

constexpr double kWide = 1e-7;  // the tolerance of vertices and edges

TopoDS_Vertex wide_vertex(double x, double y) {
  TopoDS_Vertex vertex;
  BRep_Builder().MakeVertex(vertex, gp_Pnt(x, y, 0), kWide);
  return vertex;
}

// Along y = height.
TopoDS_Edge level_edge(double from, double to, double height, const TopoDS_Vertex& first,
                       const TopoDS_Vertex& last) {
  TopoDS_Edge edge;
  const BRep_Builder builder;
  builder.MakeEdge(edge, new Geom_Line(gp_Pnt(0, height, 0), gp_Dir(1, 0, 0)), kWide);
  builder.Range(edge, from, to);
  builder.Add(edge, first.Oriented(TopAbs_FORWARD));
  builder.Add(edge, last.Oriented(TopAbs_REVERSED));
  return edge;
}

// Two vertices just outside of that of an edge's end have their feet in the end of its curve.
TEST(CloseSlivers, DividesNoEdgeAtItsEnd) {
  const BodyEdges body(BRepPrimAPI_MakeBox(1, 1, 1).Shape());
  const double off = 0.9 * kWide;
  const TopoDS_Vertex end = wide_vertex(1 + off, 0);
  const std::array beside{wide_vertex(1, off), wide_vertex(1, -off)};
  FaceBorder border{BRepBuilderAPI_MakeFace(gp_Pln()).Face(), {}, {1, 1}, 0, 0, TopAbs_FORWARD};
  border.edges = {level_edge(0, 1, 0, wide_vertex(0, 0), end),
                  level_edge(0.5, 1, off, wide_vertex(0.5, 1), beside[0]),
                  level_edge(0.5, 1, -off, wide_vertex(0.5, -1), beside[1])};
  std::vector<FaceBorder> borders{border};
  EXPECT_TRUE(close_slivers(borders, body, kWide).empty());
  EXPECT_EQ(borders.front().edges.size(), 3U);
}

}  // namespace
}  // namespace blossom::occt
