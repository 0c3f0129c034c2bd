// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces on one surface that share edges, and whose outlines leave something between these.

#include <gtest/gtest.h>

#include <cmath>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRep_Tool.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/intersection.h"

namespace blossom::occt {
namespace {

// A plate round a corner that is a line for the one and an arc for the other: they share edges on
// either side of it, and between them is a hole.
TEST(NeighboursOnOneSurface, HaveNoContactsAlongTheEdgesThatTheyShare) {
  const auto vertex = [](double x, double y) {
    return BRepBuilderAPI_MakeVertex(gp_Pnt(x, y, 0)).Vertex();
  };
  const auto line = [](const TopoDS_Vertex& from, const TopoDS_Vertex& to) {
    return BRepBuilderAPI_MakeEdge(from, to).Edge();
  };
  const TopoDS_Vertex low = vertex(0, -2), before = vertex(0, -0.1), after = vertex(0.1, 0);
  const TopoDS_Vertex end = vertex(2, 0), inner = vertex(2, -2);
  const TopoDS_Vertex corner = vertex(0, 0), far_end = vertex(2, 1), outer = vertex(-1, 1);
  const TopoDS_Vertex far_low = vertex(-1, -2);
  const TopoDS_Edge up = line(low, before), on = line(after, end);
  const gp_Pnt bend(0.1 * (1 - std::sqrt(0.5)), -0.1 * (1 - std::sqrt(0.5)), 0);
  const Handle(Geom_TrimmedCurve) arc =
      GC_MakeArcOfCircle(BRep_Tool::Pnt(before), bend, BRep_Tool::Pnt(after)).Value();
  BRepBuilderAPI_MakeWire inside(up, BRepBuilderAPI_MakeEdge(arc, before, after).Edge(), on,
                                 line(end, inner));
  inside.Add(line(inner, low));
  BRepBuilderAPI_MakeWire round(up, line(before, corner), line(corner, after), on);
  for (const TopoDS_Edge& edge :
       {line(end, far_end), line(far_end, outer), line(outer, far_low), line(far_low, low)})
    round.Add(edge);
  const auto found = self_intersect({BRepBuilderAPI_MakeFace(gp_Pln(), inside.Wire()).Face(),
                                     BRepBuilderAPI_MakeFace(gp_Pln(), round.Wire()).Face()},
                                    SelfScope::AllFaces);
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_TRUE(found.pairs.empty());
}

}  // namespace
}  // namespace blossom::occt
