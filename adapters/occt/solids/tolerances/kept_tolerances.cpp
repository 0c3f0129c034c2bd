// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/tolerances/kept_tolerances.h"

#include <BRep_TEdge.hxx>
#include <BRep_TVertex.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

namespace blossom::occt {

KeptTolerances::KeptTolerances(const TrimTool& a, const TrimTool& b) {
  TopTools_IndexedMapOfShape parts;
  for (const TrimTool* const solid : {&a, &b})
    for (const TopoDS_Face& face : solid->faces) {
      TopExp::MapShapes(face, TopAbs_EDGE, parts);
      TopExp::MapShapes(face, TopAbs_VERTEX, parts);
    }
  for (int i = 1; i <= parts.Extent(); ++i)
    were_.emplace_back(parts(i), parts(i).ShapeType() == TopAbs_EDGE
                                     ? BRep_Tool::Tolerance(TopoDS::Edge(parts(i)))
                                     : BRep_Tool::Tolerance(TopoDS::Vertex(parts(i))));
}

KeptTolerances::~KeptTolerances() {
  for (const auto& [part, tolerance] : were_)
    if (part.ShapeType() == TopAbs_EDGE)
      Handle(BRep_TEdge)::DownCast(part.TShape())->Tolerance(tolerance);
    else
      Handle(BRep_TVertex)::DownCast(part.TShape())->Tolerance(tolerance);
}

}  // namespace blossom::occt
