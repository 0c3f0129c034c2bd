// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/splitting/edges/edge_union.h"

#include <algorithm>
#include <array>
#include <vector>

#include <BRep_Builder.hxx>
#include <BRep_CurveRepresentation.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Plane.hxx>
#include <Geom_Surface.hxx>
#include <TopAbs.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/splitting/edges/edge_splits.h"
#include "adapters/occt/splitting/edges/pole_edges.h"
#include "core/base/sampled_margin.h"
#include "core/math/interval.h"

namespace blossom::occt {
namespace {

TopoDS_Edge forward(const TopoDS_Edge& edge) { return TopoDS::Edge(edge.Oriented(TopAbs_FORWARD)); }

constexpr int kUnionSamples = 17;  // both have been measured alone

// Edges that are joined may be apart: what the first one's curve is off the images of the others,
// and its vertices off the curve, becomes their tolerance.
void widen(const TopoDS_Edge& edge, double deviation) {
  const BRep_Builder builder;
  const double off = kSampledMargin * deviation;
  if (off > BRep_Tool::Tolerance(edge)) builder.UpdateEdge(edge, off);
  Interval range;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, range.from, range.to);
  if (curve.IsNull()) return;
  const auto cover = [&](const TopoDS_Vertex& vertex, double end) {
    const double gap = BRep_Tool::Pnt(vertex).Distance(curve->Value(end));
    builder.UpdateVertex(vertex, std::max(BRep_Tool::Tolerance(edge), kSampledMargin * gap));
  };
  cover(TopExp::FirstVertex(edge), range.from);
  cover(TopExp::LastVertex(edge), range.to);
}

// Edges have no image of their own in planes.
double distance_from(const Handle(Geom_Plane) & plane, const TopoDS_Edge& edge) {
  Interval range;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, range.from, range.to);
  if (curve.IsNull()) return 0;
  double largest = 0;
  for (int i = 0; i < kUnionSamples; ++i) {
    const double t = at(range, static_cast<double>(i) / (kUnionSamples - 1));
    largest = std::max(largest, plane->Pln().Distance(curve->Value(t)));
  }
  return largest;
}

constexpr std::array kInside{0.25, 0.5, 0.75};

// Whether nothing of an edge is farther from its only vertex than that one's tolerance.
bool lies_in_its_vertex(const TopoDS_Edge& edge) {
  Interval range;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, range.from, range.to);
  if (curve.IsNull()) return false;
  const TopoDS_Vertex vertex = TopExp::FirstVertex(edge);
  return std::ranges::all_of(kInside, [&](double part) {
    return BRep_Tool::Pnt(vertex).Distance(curve->Value(at(range, part))) <=
           BRep_Tool::Tolerance(vertex);
  });
}

// Whether a vertex in which an edge ends reaches the middle of that edge, which it did not before
// it was united with others.
bool reaches_middle(const TopoDS_Vertex& now, const TopoDS_Vertex& before,
                    const TopoDS_Edge& edge) {
  Interval range;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, range.from, range.to);
  if (curve.IsNull()) return false;
  const gp_Pnt middle = curve->Value(at(range, 0.5));
  const auto reaches = [&](const TopoDS_Vertex& vertex) {
    return BRep_Tool::Pnt(vertex).Distance(middle) <= BRep_Tool::Tolerance(vertex);
  };
  return reaches(now) && !reaches(before);
}

// What `from` has was made without a place of its own, so that its curves' places are in model
// space.
void take_pcurves(const TopoDS_Edge& from, const TopoDS_Edge& to, double tolerance) {
  const BRep_Builder builder;
  for (const Handle(BRep_CurveRepresentation) & on :
       Handle(BRep_TEdge)::DownCast(from.TShape())->Curves()) {
    if (on->IsCurveOnClosedSurface())
      builder.UpdateEdge(to, on->PCurve(), on->PCurve2(), on->Surface(), on->Location(), tolerance);
    else if (on->IsCurveOnSurface())
      builder.UpdateEdge(to, on->PCurve(), on->Surface(), on->Location(), tolerance);
  }
}

}  // namespace

std::size_t EdgeUnion::number(const TopoDS_Vertex& vertex) {
  const auto place = static_cast<std::size_t>(vertices_.Add(vertex)) - 1;
  if (place == sets_.size()) {
    sets_.add();
    made_.emplace_back();
  }
  return place;
}

bool EdgeUnion::join(const TopoDS_Edge& a, const TopoDS_Edge& b) { return join(a, b, b, false); }

bool EdgeUnion::join(const TopoDS_Edge& a, const TopoDS_Edge& b, const TopoDS_Edge& image,
                     bool reversed) {
  const TopoDS_Edge first = forward(a), second = forward(b);
  if (first_of_.IsBound(second) || first_of_.IsBound(first) || curves_for_.IsBound(second))
    return false;
  first_of_.Bind(second, first);
  if (!curves_for_.IsBound(first)) curves_for_.Bind(first, {});
  curves_for_(first).Append(forward(image));
  if (reversed) reversed_.Add(second);
  const TopoDS_Vertex from = TopExp::FirstVertex(second), to = TopExp::LastVertex(second);
  join(TopExp::FirstVertex(first), reversed ? to : from);
  join(TopExp::LastVertex(first), reversed ? from : to);
  return true;
}

TopoDS_Edge EdgeUnion::first(const TopoDS_Edge& edge) const {
  const TopoDS_Edge own = forward(edge);
  if (!first_of_.IsBound(own)) return edge;
  const bool turned = (edge.Orientation() == TopAbs_REVERSED) != reversed_.Contains(own);
  return TopoDS::Edge(first_of_(own).Oriented(turned ? TopAbs_REVERSED : TopAbs_FORWARD));
}

void EdgeUnion::join(const TopoDS_Vertex& a, const TopoDS_Vertex& b) {
  const std::size_t x = number(a), y = number(b);
  sets_.join(y, x);
}

// The vertex of its whole class, at the place of the root, wide enough for all.
TopoDS_Vertex EdgeUnion::united(const TopoDS_Vertex& vertex) {
  if (!vertices_.Contains(vertex)) return vertex;
  const std::size_t top = sets_.find(number(vertex));
  if (made_[top].IsNull()) {
    const gp_Pnt place = BRep_Tool::Pnt(TopoDS::Vertex(vertices_(static_cast<int>(top) + 1)));
    double tolerance = 0;
    for (std::size_t i = 0; i < sets_.size(); ++i) {
      if (sets_.find(i) != top) continue;
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
  bool changed = curves_for_.IsBound(first);
  int swallowed = 0;
  for (TopoDS_Iterator it(first); it.More(); it.Next()) {
    const TopoDS_Vertex vertex = TopoDS::Vertex(it.Value());
    const TopoDS_Vertex other = united(vertex);
    changed = changed || !other.IsSame(vertex);
    swallowed += reaches_middle(other, vertex, first) ? 1 : 0;
    builder.Add(made, other.Oriented(vertex.Orientation()));
    // The image of a degenerated edge stays in its pole.
    if (BRep_Tool::Degenerated(first))
      builder.UpdateEdge(made, BRep_Tool::Tolerance(first) +
                                   BRep_Tool::Pnt(vertex).Distance(BRep_Tool::Pnt(other)));
  }
  if (curves_for_.IsBound(first)) {
    double tolerance = BRep_Tool::Tolerance(first);
    for (const TopoDS_Shape& second : curves_for_(first))
      tolerance = std::max(tolerance, BRep_Tool::Tolerance(TopoDS::Edge(second)));
    builder.UpdateEdge(made, tolerance);
    for (const TopoDS_Shape& second : curves_for_(first))
      take_pcurves(TopoDS::Edge(second), made, tolerance);
    widen(made, image_deviation(made, kUnionSamples));
  }
  if (!changed) made = first;
  const bool was_closed = TopExp::FirstVertex(first).IsSame(TopExp::LastVertex(first));
  if (TopExp::FirstVertex(made).IsSame(TopExp::LastVertex(made)) && !was_closed) {
    if (lies_in_its_vertex(made))
      left_out_.Add(made);
    else
      ++collapsed_;
  } else {
    swallowed_ += swallowed;
  }
  made_edges_.Bind(first, made);
  return made;
}

TopoDS_Face EdgeUnion::rebuilt(const TopoDS_Face& face) {
  const BRep_Builder builder;
  TopoDS_Face made = TopoDS::Face(face.EmptyCopied());
  made.Orientation(TopAbs_FORWARD);
  const auto plane = Handle(Geom_Plane)::DownCast(BRep_Tool::Surface(face));
  bool changed = false, any = false;
  for (TopoDS_Iterator part(face.Oriented(TopAbs_FORWARD)); part.More(); part.Next()) {
    if (part.Value().ShapeType() != TopAbs_WIRE) {
      builder.Add(made, part.Value());
      continue;
    }
    std::vector<TopoDS_Edge> edges;
    for (TopoDS_Iterator it(part.Value()); it.More(); it.Next()) {
      const TopoDS_Edge edge = united(TopoDS::Edge(it.Value()));
      const TopAbs_Orientation use = it.Value().Orientation();
      changed = changed || !edge.IsSame(it.Value());
      if (!plane.IsNull() && !edge.IsSame(it.Value())) widen(edge, distance_from(plane, edge));
      if (left_out_.Contains(edge)) continue;
      edges.push_back(
          TopoDS::Edge(edge.Oriented(reversed_.Contains(it.Value()) ? TopAbs::Reverse(use) : use)));
    }
    if (edges.empty()) {
      ++lost_wires_;
      continue;
    }
    any = true;
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    for (const TopoDS_Edge& edge : with_fitted_poles(edges, made)) builder.Add(wire, edge);
    wire.Closed(part.Value().Closed());
    builder.Add(made, wire);
  }
  if (!changed) return face;
  made.Orientation(face.Orientation());
  return any ? made : TopoDS_Face();
}

}  // namespace blossom::occt
