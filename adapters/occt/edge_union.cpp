// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/edge_union.h"

#include <algorithm>

#include <BRep_Builder.hxx>
#include <BRep_CurveRepresentation.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>

namespace blossom::occt {
namespace {

TopoDS_Edge forward(const TopoDS_Edge& edge) { return TopoDS::Edge(edge.Oriented(TopAbs_FORWARD)); }

// Both were made without a place of their own, so that their curves' places are in model space.
void take_pcurves(const TopoDS_Edge& from, const TopoDS_Edge& to, double tolerance) {
  for (const Handle(BRep_CurveRepresentation) & on :
       Handle(BRep_TEdge)::DownCast(from.TShape())->Curves())
    if (on->IsCurveOnSurface())
      BRep_Builder().UpdateEdge(to, on->PCurve(), on->Surface(), on->Location(), tolerance);
}

}  // namespace

std::size_t EdgeUnion::number(const TopoDS_Vertex& vertex) {
  const auto place = static_cast<std::size_t>(vertices_.Add(vertex)) - 1;
  if (place == parent_.size()) {
    parent_.push_back(place);
    made_.emplace_back();
  }
  return place;
}

std::size_t EdgeUnion::root(std::size_t vertex) {
  while (parent_[vertex] != vertex) vertex = parent_[vertex] = parent_[parent_[vertex]];
  return vertex;
}

void EdgeUnion::join(const TopoDS_Edge& a, const TopoDS_Edge& b) {
  const TopoDS_Edge first = forward(a), second = forward(b);
  first_of_.Bind(second, first);
  second_of_.Bind(first, second);
  for (const auto vertex_of : {&TopExp::FirstVertex, &TopExp::LastVertex}) {
    const std::size_t x = number(vertex_of(first, Standard_False));
    const std::size_t y = number(vertex_of(second, Standard_False));
    parent_[root(y)] = root(x);
  }
}

// The vertex of its whole class, at the place of the root, wide enough for all.
TopoDS_Vertex EdgeUnion::united(const TopoDS_Vertex& vertex) {
  if (!vertices_.Contains(vertex)) return vertex;
  const std::size_t top = root(number(vertex));
  if (made_[top].IsNull()) {
    const gp_Pnt place = BRep_Tool::Pnt(TopoDS::Vertex(vertices_(static_cast<int>(top) + 1)));
    double tolerance = 0;
    for (std::size_t i = 0; i < parent_.size(); ++i) {
      if (root(i) != top) continue;
      const TopoDS_Vertex member = TopoDS::Vertex(vertices_(static_cast<int>(i) + 1));
      tolerance = std::max(tolerance,
                           BRep_Tool::Tolerance(member) + place.Distance(BRep_Tool::Pnt(member)));
    }
    BRep_Builder().MakeVertex(made_[top], place, tolerance);
  }
  return made_[top];
}

TopoDS_Edge EdgeUnion::united(const TopoDS_Edge& edge) {
  const TopoDS_Edge own = forward(edge);
  const TopoDS_Edge first = first_of_.IsBound(own) ? TopoDS::Edge(first_of_(own)) : own;
  if (made_edges_.IsBound(first)) return TopoDS::Edge(made_edges_(first));
  const BRep_Builder builder;
  TopoDS_Edge made = TopoDS::Edge(first.EmptyCopied());
  bool changed = second_of_.IsBound(first);
  for (TopoDS_Iterator it(first); it.More(); it.Next()) {
    const TopoDS_Vertex vertex = TopoDS::Vertex(it.Value());
    const TopoDS_Vertex other = united(vertex);
    changed = changed || !other.IsSame(vertex);
    builder.Add(made, other.Oriented(vertex.Orientation()));
  }
  if (second_of_.IsBound(first)) {
    const TopoDS_Edge second = TopoDS::Edge(second_of_(first));
    const double tolerance = std::max(BRep_Tool::Tolerance(first), BRep_Tool::Tolerance(second));
    builder.UpdateEdge(made, tolerance);
    take_pcurves(second, made, tolerance);
  }
  if (!changed) made = first;
  const bool was_closed = TopExp::FirstVertex(first).IsSame(TopExp::LastVertex(first));
  if (TopExp::FirstVertex(made).IsSame(TopExp::LastVertex(made)) && !was_closed) ++collapsed_;
  made_edges_.Bind(first, made);
  return made;
}

TopoDS_Face EdgeUnion::rebuilt(const TopoDS_Face& face) {
  const BRep_Builder builder;
  TopoDS_Face made = TopoDS::Face(face.EmptyCopied());
  made.Orientation(TopAbs_FORWARD);
  bool changed = false;
  for (TopoDS_Iterator part(face.Oriented(TopAbs_FORWARD)); part.More(); part.Next()) {
    if (part.Value().ShapeType() != TopAbs_WIRE) {
      builder.Add(made, part.Value());
      continue;
    }
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    for (TopoDS_Iterator it(part.Value()); it.More(); it.Next()) {
      const TopoDS_Edge edge = united(TopoDS::Edge(it.Value()));
      changed = changed || !edge.IsSame(it.Value());
      builder.Add(wire, edge.Oriented(it.Value().Orientation()));
    }
    wire.Closed(part.Value().Closed());
    builder.Add(made, wire);
  }
  made.Orientation(face.Orientation());
  return changed ? made : face;
}

}  // namespace blossom::occt
