// SPDX-License-Identifier: LGPL-2.1-or-later
// A body whose inner corner has chamfers on top.

#pragma once

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/edge_facts.h"

namespace blossom::testing {

/// An angle of two bars with chamfers of 2 along its upper edges. Its inner corner is at (15, 10).
inline TopoDS_Shape chamfered_angle() {
  BRepBuilderAPI_MakePolygon outline;
  for (const gp_Pnt& each : {gp_Pnt(0, 0, 0), gp_Pnt(30, 0, 0), gp_Pnt(30, 10, 0),
                             gp_Pnt(15, 10, 0), gp_Pnt(15, 20, 0), gp_Pnt(0, 20, 0)})
    outline.Add(each);
  outline.Close();
  const TopoDS_Shape angle =
      BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 0, 10))
          .Shape();
  BRepFilletAPI_MakeChamfer chamfer(angle);
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(angle, TopAbs_EDGE, edges);
  for (const occt::EdgeFacts& each : occt::edge_facts(angle))
    if (each.middle[2] > 9.9) chamfer.Add(2, TopoDS::Edge(edges(each.number)));
  return chamfer.Shape();
}

}  // namespace blossom::testing
