// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/blend_edges.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <GeomAbs_Shape.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp.hxx>
#include <gp_Vec2d.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/curves.h"
#include "adapters/occt/convert/surfaces.h"

namespace blossom::occt {
namespace {

constexpr double kMargin = 1.1;  // tolerances cover sampled distances with it
constexpr int kDeviationSamples = 64;
constexpr int kSpanSamples = 8;  // of each span of splines, between whose knots deviations swing
constexpr int kNearSamples = 64;
constexpr int kClosedSamples = 16;
constexpr int kNewtonSteps = 12;

// The ends of the spans of a curve in a range.
template <typename Adaptor>
std::vector<double> span_ends(const Adaptor& curve) {
  TColStd_Array1OfReal ends(1, curve.NbIntervals(GeomAbs_CN) + 1);
  curve.Intervals(ends, GeomAbs_CN);
  return {ends.begin(), ends.end()};
}

double deviation(const TopoDS_Edge& edge, const Handle(Geom2d_Curve) & chart,
                 const Handle(Geom_Surface) & surface) {
  Interval range;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, range.from, range.to);
  std::vector<double> ends = span_ends(GeomAdaptor_Curve(curve, range.from, range.to));
  const std::vector<double> of_chart = span_ends(Geom2dAdaptor_Curve(chart, range.from, range.to));
  ends.insert(ends.end(), of_chart.begin(), of_chart.end());
  std::ranges::sort(ends);
  const int spans = static_cast<int>(ends.size()) - 1;
  const int samples = std::max(kSpanSamples, (kDeviationSamples + spans - 1) / spans);
  double largest = 0;
  for (std::size_t span = 0; span + 1 < ends.size(); ++span) {
    if (ends[span + 1] == ends[span]) continue;
    for (int i = 0; i <= samples; ++i) {
      const double t = at(Interval{ends[span], ends[span + 1]}, static_cast<double>(i) / samples);
      const gp_Pnt2d uv = chart->Value(t);
      largest = std::max(largest, curve->Value(t).Distance(surface->Value(uv.X(), uv.Y())));
    }
  }
  return largest;
}

void widen(const TopoDS_Edge& edge, double tolerance) {
  const BRep_Builder builder;
  builder.UpdateEdge(edge, tolerance);
  builder.UpdateVertex(TopExp::FirstVertex(edge), tolerance);
  builder.UpdateVertex(TopExp::LastVertex(edge), tolerance);
}

}  // namespace

Vec3 point_of(const TopoDS_Vertex& vertex) { return vec(BRep_Tool::Pnt(vertex).XYZ()); }

TopoDS_Vertex vertex_at(const Vec3& point) {
  TopoDS_Vertex vertex;
  BRep_Builder().MakeVertex(vertex, {point[0], point[1], point[2]}, Precision::Confusion());
  return vertex;
}

TopoDS_Face plane_face(const Vec3& a, const Vec3& b, const Vec3& c) {
  TopoDS_Face face;
  const Vec3 normal = cross(b - a, c - a);
  BRep_Builder().MakeFace(face, new Geom_Plane(pnt(a), dir(unit(normal))), Precision::Confusion());
  return face;
}

void cover(const TopoDS_Vertex& vertex, const Vec3& point, double tolerance) {
  const double gap = distance(point_of(vertex), point);
  BRep_Builder().UpdateVertex(vertex, std::max(tolerance, kMargin * gap));
}

namespace {

// An end that misses its vertex by more than a hair belongs to edges with tolerances. Where it
// leaves an edge beside it at 20 degrees, both are within that miss of each other up to three times
// as far from the vertex; BRepCheck wants all of that within the vertex.
constexpr double kEndMargin = 3;

void cover_end(const TopoDS_Vertex& vertex, const Vec3& end) {
  const double miss = distance(point_of(vertex), end);
  cover(vertex, end,
        std::max(Precision::Confusion(), miss > Precision::Confusion() ? kEndMargin * miss : 0));
}

}  // namespace

TopoDS_Edge edge_on(const Handle(Geom_Curve) & curve, const Interval& range,
                    const TopoDS_Vertex& from, const TopoDS_Vertex& to) {
  const BRep_Builder builder;
  TopoDS_Edge edge;
  builder.MakeEdge(edge, curve, Precision::Confusion());
  builder.Range(edge, range.from, range.to);
  builder.Add(edge, from.Oriented(TopAbs_FORWARD));
  builder.Add(edge, to.Oriented(TopAbs_REVERSED));
  cover_end(from, vec(curve->Value(range.from).XYZ()));
  cover_end(to, vec(curve->Value(range.to).XYZ()));
  leave_periods(edge);
  return edge;
}

void add_chart(const TopoDS_Edge& edge, const Handle(Geom2d_Curve) & chart,
               const TopoDS_Face& face) {
  TopLoc_Location location;
  const Handle(Geom_Surface) raw = BRep_Tool::Surface(face, location);
  BRep_Builder().UpdateEdge(edge, chart, raw, location, Precision::Confusion());
  widen(edge, kMargin * deviation(edge, chart, BRep_Tool::Surface(face)));
  leave_periods(edge);
}

void add_seam_charts(const TopoDS_Edge& edge, const Handle(Geom2d_Curve) & forward,
                     const Handle(Geom2d_Curve) & reversed, const TopoDS_Face& face) {
  TopLoc_Location location;
  const Handle(Geom_Surface) raw = BRep_Tool::Surface(face, location);
  BRep_Builder().UpdateEdge(edge, forward, reversed, raw, location, Precision::Confusion());
  for (const auto& chart : {forward, reversed})
    widen(edge, kMargin * deviation(edge, chart, BRep_Tool::Surface(face)));
}

namespace {

// Open CASCADE says of no offset surface that it is closed. It is where the surface below it is,
// and has no crease there: seen at samples of the borders.
bool is_closed_offset(const Handle(Geom_Surface) & surface, const std::array<Interval, 2>& box,
                      bool in_u) {
  const auto offset = Handle(Geom_OffsetSurface)::DownCast(surface);
  if (offset.IsNull()) return false;
  const Handle(Geom_Surface)& basis = offset->BasisSurface();
  if (!(in_u ? basis->IsUClosed() : basis->IsVClosed())) return false;
  const Interval &across = box[in_u ? 0 : 1], &along = box[in_u ? 1 : 0];
  for (int i = 0; i <= kClosedSamples; ++i) {
    const double t = at(along, static_cast<double>(i) / kClosedSamples);
    const gp_Pnt low = in_u ? surface->Value(across.from, t) : surface->Value(t, across.from);
    const gp_Pnt high = in_u ? surface->Value(across.to, t) : surface->Value(t, across.to);
    if (low.Distance(high) > Precision::Confusion()) return false;
  }
  return true;
}

}  // namespace

std::array<double, 2> turns_of(const Handle(Geom_Surface) & given) {
  const Handle(Geom_Surface) surface = basis_of(given);
  Interval u, v;
  surface->Bounds(u.from, u.to, v.from, v.to);
  std::array<double, 2> turns{};
  if (surface->IsUPeriodic())
    turns[0] = surface->UPeriod();
  else if (surface->IsUClosed() || is_closed_offset(surface, {u, v}, true))
    turns[0] = length(u);
  if (surface->IsVPeriodic())
    turns[1] = surface->VPeriod();
  else if (surface->IsVClosed() || is_closed_offset(surface, {u, v}, false))
    turns[1] = length(v);
  return turns;
}

Handle(Geom2d_Curve) chart_near_face(const Handle(Geom2d_Curve) & chart, double at,
                                     const BodyEdges& body, int face) {
  const FaceTrims& trims = body.trims(face);
  const std::array<double, 2> turns = turns_of(BRep_Tool::Surface(body.face(face)));
  const gp_Pnt2d there = chart->Value(at);
  const Vec2 middle = 0.5 * (trims.box.low + trims.box.high);
  Vec2 best;
  double least = std::numeric_limits<double>::infinity();
  // The turn that brings it nearest to the middle, and those beside it.
  const std::array<int, 2> room{turns[0] > 0 ? 1 : 0, turns[1] > 0 ? 1 : 0};
  for (int i = -room[0]; i <= room[0]; ++i)
    for (int k = -room[1]; k <= room[1]; ++k) {
      Vec2 move;
      const std::array<int, 2> step{i, k};
      for (int d = 0; d < 2; ++d) {
        const double turn = turns[static_cast<std::size_t>(d)];
        if (turn == 0) continue;
        const double off = middle[d] / trims.scale[d] - (d == 0 ? there.X() : there.Y());
        move[d] = turn * (std::round(off / turn) + step[static_cast<std::size_t>(d)]);
      }
      const Vec2 point{(there.X() + move[0]) * trims.scale[0],
                       (there.Y() + move[1]) * trims.scale[1]};
      Vec2 beside;
      for (int d = 0; d < 2; ++d)
        beside[d] = std::max({trims.box.low[d] - point[d], point[d] - trims.box.high[d], 0.0});
      const double outside = is_inside(trims, point) ? -1 : norm(beside);
      if (outside >= least) continue;
      least = outside;
      best = move;
    }
  if (norm(best) == 0) return chart;
  const auto moved = Handle(Geom2d_Curve)::DownCast(chart->Copy());
  moved->Translate(gp_Vec2d(best[0], best[1]));
  return moved;
}

double nearest_on(const Handle(Geom_Curve) & curve, const Interval& range, const Vec3& point) {
  const gp_Pnt target(point[0], point[1], point[2]);
  double best = range.from, least = curve->Value(range.from).SquareDistance(target);
  for (int i = 1; i <= kNearSamples; ++i) {
    const double t = at(range, static_cast<double>(i) / kNearSamples);
    const double square = curve->Value(t).SquareDistance(target);
    if (square < least) {
      least = square;
      best = t;
    }
  }
  for (int i = 0; i < kNewtonSteps; ++i) {
    gp_Pnt p;
    gp_Vec first, second;
    curve->D2(best, p, first, second);
    const gp_Vec off(target, p);
    const double slope = first.SquareMagnitude() + off.Dot(second);
    const double step = slope > 0 ? off.Dot(first) / slope : 0;
    const double next = std::clamp(best - step, range.from, range.to);
    if (next == best) break;
    best = next;
  }
  return best;
}

}  // namespace blossom::occt
