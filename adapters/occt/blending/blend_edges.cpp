// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/blend_edges.h"

#include <algorithm>
#include <cmath>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>

namespace blossom::occt {
namespace {

constexpr double kMargin = 1.1;  // tolerances cover sampled distances with it
constexpr int kDeviationSamples = 64;
constexpr int kNearSamples = 64;
constexpr int kNewtonSteps = 12;

Vec3 vec(const gp_XYZ& p) { return {p.X(), p.Y(), p.Z()}; }

double deviation(const TopoDS_Edge& edge, const Handle(Geom2d_Curve) & chart,
                 const Handle(Geom_Surface) & surface) {
  Interval range;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, range.from, range.to);
  double largest = 0;
  for (int i = 0; i <= kDeviationSamples; ++i) {
    const double t = at(range, static_cast<double>(i) / kDeviationSamples);
    const gp_Pnt2d uv = chart->Value(t);
    largest = std::max(largest, curve->Value(t).Distance(surface->Value(uv.X(), uv.Y())));
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

void cover(const TopoDS_Vertex& vertex, const Vec3& point, double tolerance) {
  const double gap = distance(point_of(vertex), point);
  BRep_Builder().UpdateVertex(vertex, std::max(tolerance, kMargin * gap));
}

TopoDS_Edge edge_on(const Handle(Geom_Curve) & curve, const Interval& range,
                    const TopoDS_Vertex& from, const TopoDS_Vertex& to) {
  const BRep_Builder builder;
  TopoDS_Edge edge;
  builder.MakeEdge(edge, curve, Precision::Confusion());
  builder.Range(edge, range.from, range.to);
  builder.Add(edge, from.Oriented(TopAbs_FORWARD));
  builder.Add(edge, to.Oriented(TopAbs_REVERSED));
  cover(from, vec(curve->Value(range.from).XYZ()), Precision::Confusion());
  cover(to, vec(curve->Value(range.to).XYZ()), Precision::Confusion());
  return edge;
}

void add_chart(const TopoDS_Edge& edge, const Handle(Geom2d_Curve) & chart,
               const TopoDS_Face& face) {
  TopLoc_Location location;
  const Handle(Geom_Surface) raw = BRep_Tool::Surface(face, location);
  BRep_Builder().UpdateEdge(edge, chart, raw, location, Precision::Confusion());
  widen(edge, kMargin * deviation(edge, chart, BRep_Tool::Surface(face)));
}

void add_seam_charts(const TopoDS_Edge& edge, const Handle(Geom2d_Curve) & forward,
                     const Handle(Geom2d_Curve) & reversed, const TopoDS_Face& face) {
  TopLoc_Location location;
  const Handle(Geom_Surface) raw = BRep_Tool::Surface(face, location);
  BRep_Builder().UpdateEdge(edge, forward, reversed, raw, location, Precision::Confusion());
  for (const auto& chart : {forward, reversed})
    widen(edge, kMargin * deviation(edge, chart, BRep_Tool::Surface(face)));
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
