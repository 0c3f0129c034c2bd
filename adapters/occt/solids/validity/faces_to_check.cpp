// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/validity/faces_to_check.h"

#include <BRep_Tool.hxx>
#include <Geom_Plane.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

#include "adapters/occt/convert/edge_charts.h"

namespace blossom::occt {

TopoDS_Face FacesToCheck::add(const TopoDS_Face& face) {
  const TopoDS_Face copy = TopoDS::Face(copy_of(face));
  builder_.NaturalRestriction(copy, BRep_Tool::NaturalRestriction(face));
  keep_chart_curves(copy);
  builder_.Add(all_, copy);
  return copy;
}

// Vertices are shared, copies of edges as the edges are.
TopoDS_Shape FacesToCheck::copy_of(const TopoDS_Shape& shape) {
  if (shape.ShapeType() == TopAbs_VERTEX) return shape;
  const TopoDS_Shape bare = shape.Located(TopLoc_Location()).Oriented(TopAbs_FORWARD);
  if (!copies_.IsBound(bare)) {
    TopoDS_Shape copy = bare.EmptyCopied();
    for (TopoDS_Iterator part(bare, Standard_False, Standard_False); part.More(); part.Next())
      builder_.Add(copy, copy_of(part.Value()));
    copy.Closed(bare.Closed());
    copies_.Bind(bare, copy);
  }
  // Also at a place that mirrors, which Open CASCADE uses, but wants to make no more.
  return copies_(bare).Located(shape.Location(), false).Oriented(shape.Orientation());
}

void FacesToCheck::keep_chart_curves(const TopoDS_Face& face) {
  TopLoc_Location place;
  const Handle(Geom_Surface)& surface = BRep_Tool::Surface(face, place);
  if (!surface->IsKind(STANDARD_TYPE(Geom_Plane))) return;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
    if (keeps_chart_curve(edge, face)) continue;
    Interval range;
    const Handle(Geom2d_Curve) curve = chart_curve_of(edge, face, range);
    if (curve.IsNull()) continue;
    builder_.UpdateEdge(edge, curve, surface, place, BRep_Tool::Tolerance(edge));
    builder_.Range(edge, surface, place, range.from, range.to);
  }
}

}  // namespace blossom::occt
