// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/faces/face_trims.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <BRep_Tool.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Surface.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/edge_charts.h"
#include "adapters/occt/convert/pcurves.h"
#include "adapters/occt/convert/surfaces.h"

namespace blossom::occt {
namespace {

// Null vertices are not numbered.
int number_of(const TopoDS_Vertex& vertex, TrimShapes& shapes) {
  return vertex.IsNull() ? -1 : shapes.vertices.Add(vertex) - 1;
}

// Calls work(edge, whether it is internal, whether it is the first one of a wire) for each use of
// an edge by a face that is turned forward.
template <class Work>
void for_uses(const TopoDS_Face& face, Work work) {
  for (TopoDS_Iterator wire(face); wire.More(); wire.Next()) {
    if (wire.Value().ShapeType() != TopAbs_WIRE) continue;
    bool begins = true;
    for (TopoDS_Iterator it(wire.Value()); it.More(); it.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(it.Value());
      const TopAbs_Orientation use = edge.Orientation();
      if (use == TopAbs_INTERNAL) work(TopoDS::Edge(edge.Oriented(TopAbs_FORWARD)), true, false);
      if (use != TopAbs_FORWARD && use != TopAbs_REVERSED) continue;
      work(edge, false, begins);
      begins = false;
    }
  }
}

Coedge coedge_of(const TopoDS_Edge& edge, const TopoDS_Face& face, TrimShapes& shapes) {
  Interval range;
  const Handle(Geom2d_Curve) pcurve = chart_curve_of(edge, face, range);
  if (pcurve.IsNull()) throw BadModel("an edge has no parametric curve on the face it bounds");
  Coedge coedge;
  coedge.edge = shapes.edges.Add(edge) - 1;
  coedge.reversed = edge.Orientation() == TopAbs_REVERSED;
  coedge.curve = planar_curve(pcurve, range);
  coedge.degenerated = BRep_Tool::Degenerated(edge);
  coedge.tolerance = BRep_Tool::Tolerance(edge);
  coedge.start = number_of(TopExp::FirstVertex(edge, Standard_True), shapes);
  coedge.end = number_of(TopExp::LastVertex(edge, Standard_True), shapes);
  return coedge;
}

double power_of_two(double length) {
  return length > 0 && std::isfinite(length) ? std::exp2(std::round(std::log2(length))) : 1.0;
}

// The derivatives of a polynomial patch by their control points.
Vec2 chart_scale(const Geom_BezierSurface& patch) {
  const TColgp_Array2OfPnt& p = patch.Poles();
  const int rows = p.ColLength(), columns = p.RowLength();
  Vec2 sum;
  for (int i = 1; i <= rows; ++i)
    for (int j = 1; j <= columns; ++j) {
      if (i < rows) sum[0] += p(i, j).Distance(p(i + 1, j));
      if (j < columns) sum[1] += p(i, j).Distance(p(i, j + 1));
    }
  return {power_of_two(sum[0] / columns), power_of_two(sum[1] / rows)};
}

// Of a Bezier patch.
bool covers_most(const PlanarBox& box) {
  return std::min(box.high[0] - box.low[0], box.high[1] - box.low[1]) >= 0.5;
}

// The mean lengths of the surface's derivatives over the box, rounded to powers of two.
Vec2 chart_scale(const Handle(Geom_Surface) & surface, const PlanarBox& box) {
  constexpr int kSamples = 5;
  const auto patch = Handle(Geom_BezierSurface)::DownCast(surface);
  if (!patch.IsNull() && !patch->IsURational() && !patch->IsVRational() && covers_most(box))
    return chart_scale(*patch);
  // Keeps the polynomial of its last span, which a Bezier surface never leaves.
  const GeomAdaptor_Surface quick(surface);
  const bool one_span = quick.GetType() == GeomAbs_BezierSurface;
  Vec2 sum;
  for (int i = 0; i < kSamples; ++i)
    for (int j = 0; j < kSamples; ++j) {
      const double u = at({box.low[0], box.high[0]}, (i + 0.5) / kSamples);
      const double v = at({box.low[1], box.high[1]}, (j + 0.5) / kSamples);
      gp_Pnt point;
      gp_Vec du, dv;
      one_span ? quick.D1(u, v, point, du, dv) : surface->D1(u, v, point, du, dv);
      sum += {du.Magnitude(), dv.Magnitude()};
    }
  return {power_of_two(sum[0] / (kSamples * kSamples)),
          power_of_two(sum[1] / (kSamples * kSamples))};
}

// Natural bounds, and the period also of a rectangle of a surface, to which Open CASCADE gives
// none.
SurfaceChart chart_of(const Handle(Geom_Surface) & surface, const PlanarBox& loops) {
  SurfaceChart chart;
  chart.jet = [surface](const Vec2& uv) {
    gp_Pnt point;
    gp_Vec du, dv;
    surface->D1(uv[0], uv[1], point, du, dv);
    return SurfaceJet{vec(point), vec(du), vec(dv)};
  };
  surface->Bounds(chart.bounds.low[0], chart.bounds.high[0], chart.bounds.low[1],
                  chart.bounds.high[1]);
  const Handle(Geom_Surface) whole = basis_of(surface);
  chart.period = {whole->IsUPeriodic() ? whole->UPeriod() : 0,
                  whole->IsVPeriodic() ? whole->VPeriod() : 0};
  chart.scale = chart_scale(surface, loops);
  return chart;
}

std::vector<FaceVertex> vertices_of(const TrimShapes& shapes) {
  std::vector<FaceVertex> vertices;
  for (int i = 1; i <= shapes.vertices.Extent(); ++i) {
    const TopoDS_Vertex vertex = TopoDS::Vertex(shapes.vertices(i));
    vertices.push_back({vec(BRep_Tool::Pnt(vertex)), BRep_Tool::Tolerance(vertex)});
  }
  return vertices;
}

}  // namespace

FaceTrims face_trims(const TopoDS_Face& face) {
  const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(forward);
  if (surface.IsNull()) throw BadModel("a face has no surface");
  TrimShapes shapes;
  std::vector<std::vector<Coedge>> loops;
  std::vector<Coedge> inner;
  for_uses(forward, [&](const TopoDS_Edge& edge, bool internal, bool begins) {
    if (begins) loops.emplace_back();
    (internal ? inner : loops.back()).push_back(coedge_of(edge, forward, shapes));
  });
  if (loops.empty()) throw BadModel("a face has no wire");
  for (const auto& loop : loops)
    for (const Coedge& coedge : loop)
      if (coedge.start < 0 || coedge.end < 0) throw BadModel("an edge of a face has no vertices");
  const SurfaceChart chart = chart_of(surface, blossom::box_of(loops));
  auto trims = trims_of(chart, vertices_of(shapes), std::move(loops), std::move(inner));
  if (!trims) throw BadModel("a wire of a face is open");
  return *std::move(trims);
}

TopoDS_Edge TrimShapes::edge(const Coedge& coedge) const {
  return TopoDS::Edge(
      edges(coedge.edge + 1).Oriented(coedge.reversed ? TopAbs_REVERSED : TopAbs_FORWARD));
}

TopoDS_Shape TrimShapes::at(const std::optional<TrimPlace>& place) const {
  if (!place) return {};
  return place->vertex < 0 ? TopoDS_Shape(edge(*place->coedge)) : vertices(place->vertex + 1);
}

TrimShapes trim_shapes(const TopoDS_Face& face) {
  TrimShapes shapes;
  for_uses(TopoDS::Face(face.Oriented(TopAbs_FORWARD)), [&](const TopoDS_Edge& edge, bool, bool) {
    shapes.edges.Add(edge);
    number_of(TopExp::FirstVertex(edge, Standard_True), shapes);
    number_of(TopExp::LastVertex(edge, Standard_True), shapes);
  });
  return shapes;
}

}  // namespace blossom::occt
