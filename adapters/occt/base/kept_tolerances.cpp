// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/base/kept_tolerances.h"

#include <BRep_Builder.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_TVertex.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

namespace blossom::occt {
namespace {

double tolerance_of(const TopoDS_Shape& part) {
  return part.ShapeType() == TopAbs_EDGE ? BRep_Tool::Tolerance(TopoDS::Edge(part))
                                         : BRep_Tool::Tolerance(TopoDS::Vertex(part));
}

TopoDS_Shape copy_of(const TopoDS_Shape& part) {
  TopoDS_Shape copy = part.EmptyCopied();
  for (TopoDS_Iterator it(part, Standard_False); it.More(); it.Next())
    BRep_Builder().Add(copy, it.Value());
  return copy;
}

}  // namespace

void KeptTolerances::remember(const std::vector<TopoDS_Face>& faces) {
  for (const TopoDS_Face& face : faces)
    for (const TopAbs_ShapeEnum kind : {TopAbs_EDGE, TopAbs_VERTEX})
      TopExp::MapShapes(face, kind, known_);
  for (int i = static_cast<int>(were_.size()) + 1; i <= known_.Extent(); ++i)
    were_.emplace_back(known_(i), tolerance_of(known_(i)));
}

Handle(BRepTools_ReShape) KeptTolerances::parted() {
  Handle(BRepTools_ReShape) copies;
  for (const auto& [part, tolerance] : were_) {
    if (tolerance_of(part) == tolerance) continue;
    if (copies.IsNull()) copies = new BRepTools_ReShape;
    const TopoDS_Shape forward = part.Oriented(TopAbs_FORWARD);
    copies->Replace(forward, copy_of(forward));
  }
  put_back();
  leave();
  return copies;
}

void KeptTolerances::put_back() {
  for (const auto& [part, tolerance] : were_)
    if (part.ShapeType() == TopAbs_EDGE)
      Handle(BRep_TEdge)::DownCast(part.TShape())->Tolerance(tolerance);
    else
      Handle(BRep_TVertex)::DownCast(part.TShape())->Tolerance(tolerance);
}

}  // namespace blossom::occt
