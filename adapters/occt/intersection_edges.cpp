// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/intersection_edges.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRep_Builder.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>

#include "adapters/occt/base/errors.h"

namespace blossom::occt {

std::vector<TopoDS_Face> faces_of(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape map;
  if (!shape.IsNull()) TopExp::MapShapes(shape, TopAbs_FACE, map);
  std::vector<TopoDS_Face> faces;
  for (int i = 1; i <= map.Extent(); ++i) faces.push_back(TopoDS::Face(map(i)));
  return faces;
}

TopoDS_Edge edge_of(const EdgeCurves& curves) {
  return guarded("making an edge of an intersection curve", [&] {
    BRepBuilderAPI_MakeEdge maker(curves.curve);
    if (!maker.IsDone()) throw Failure("an intersection curve gives no edge");
    TopoDS_Edge edge = maker.Edge();
    const BRep_Builder builder;
    builder.UpdateEdge(edge, curves.tolerance);
    for (const TopoDS_Vertex& end : {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)})
      builder.UpdateVertex(end, curves.tolerance);
    return edge;
  });
}

TopoDS_Compound compound_of(const ShapeIntersection& found) {
  const BRep_Builder builder;
  TopoDS_Compound compound;
  builder.MakeCompound(compound);
  for (const FaceIntersection& pair : found.pairs) {
    for (const EdgeCurves& curves : pair.edges) builder.Add(compound, edge_of(curves));
    for (const SurfacePoint& contact : pair.found.points) {
      const Vec3& p = contact.point;
      builder.Add(compound, BRepBuilderAPI_MakeVertex(gp_Pnt(p[0], p[1], p[2])).Vertex());
    }
  }
  return compound;
}

}  // namespace blossom::occt
