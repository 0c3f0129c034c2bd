// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/faces/pairs/edge_contacts.h"

#include <algorithm>

#include <BRep_Tool.hxx>
#include <Geom_Curve.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/curves.h"
#include "adapters/occt/convert/edge_charts.h"
#include "core/base/unbounded.h"
#include "core/bounds/box_tree.h"
#include "core/curve_intersection.h"

namespace blossom::occt {
namespace {

// An edge of a face, in space and in the face's parameters.
struct Outline {
  OutlineEdge of;
  CurveSpans spans;
  Box box;  // of the control points
};

Box box_of(const CurveSpans& curve) {
  Box box;
  for (const CurveSpan& span : curve.spans)
    for (const Vec4& p : span.curve.points) {
      const Vec3 point = projected(p);
      box = joined(box, {point, point});
    }
  return box;
}

std::vector<Outline> outlines_of(const TopoDS_Face& face) {
  std::vector<Outline> outlines;
  for (TopExp_Explorer part(face, TopAbs_EDGE); part.More(); part.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(part.Current());
    if (BRep_Tool::Degenerated(edge)) continue;
    Interval range;
    const Handle(Geom2d_Curve) chart = chart_curve_of(edge, face, range);
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, range.from, range.to);
    if (curve.IsNull() || chart.IsNull())
      throw BadModel("an edge has no curve in space or on its face");
    outlines.push_back({{edge, chart, is_seam(edge, face)}, bezier_spans(curve, range), {}});
    outlines.back().box = box_of(outlines.back().spans);
  }
  return outlines;
}

Vec2 value(const Handle(Geom2d_Curve) & chart, double t) {
  const gp_Pnt2d p = chart->Value(t);
  return {p.X(), p.Y()};
}

bool holds(const Interval& place, double t) { return place.from <= t && t <= place.to; }

// Whether a contact of the search is among its points or runs.
bool is_reported(const CurvePlace& place, const CurveIntersection& found) {
  if (place.kind == PlaceKind::Open) return false;
  if (place.kind == PlaceKind::Overlap)
    return std::ranges::any_of(found.overlaps, [&](const CurveOverlap& run) {
      return run.a.from <= place.a.to && place.a.from <= run.a.to;
    });
  return std::ranges::any_of(found.points, [&](const CurvePoint& x) {
    return holds(place.a, x.a) && holds(place.b, x.b);
  });
}

// The end of one of two edges that is nearest to a point, as its distance from it.
double distance_to_ends(const Outline& p, const Outline& q, const Vec3& point) {
  double least = kUnbounded;
  for (const CurveSpans* of : {&p.spans, &q.spans})
    for (const double end : {of->domain().from, of->domain().to})
      least = std::min(least, distance(point_at(*of, end), point));
  return least;
}

// Edges that cross within tolerance of their ends may as well only touch there: they are as far
// apart as what one goes past the other.
void add(const Outline& p, const Outline& q, const CurveIntersection& found, double tolerance,
         OutlineContacts& contacts) {
  for (const CurvePoint& x : found.points) {
    double gap = distance(point_at(p.spans, x.a), point_at(q.spans, x.b));
    const double past = distance_to_ends(p, q, x.point);
    const bool crosses = x.proven && past > tolerance;
    if (x.proven && !crosses) gap = std::max(gap, past);
    const auto known = std::ranges::find_if(contacts.points, [&](const OutlinePoint& other) {
      return distance(other.at.point, x.point) <= 2 * tolerance;
    });
    if (known == contacts.points.end()) {
      contacts.points.push_back(
          {{x.point, value(p.of.chart, x.a), value(q.of.chart, x.b)}, gap, crosses});
    } else {
      known->gap = std::max(known->gap, gap);
      known->crosses = known->crosses || crosses;
    }
  }
  for (const CurveOverlap& run : found.overlaps)
    contacts.runs.push_back({p.of, q.of, run.a, run.b, run.gap_high, run.proven});
  contacts.complete = contacts.complete && found.status != Status::Stopped &&
                      std::ranges::all_of(found.places, [&](const CurvePlace& place) {
                        return is_reported(place, found);
                      });
}

}  // namespace

OutlineContacts outline_contacts(const TopoDS_Face& a, const TopoDS_Face& b, double tolerance) {
  IntersectionOptions options;
  options.tolerances.point = tolerance;
  OutlineContacts contacts;
  const std::vector<Outline> all_b = outlines_of(b);
  for (const Outline& p : outlines_of(a))
    for (const Outline& q : all_b)
      if (meet(widened(p.box, tolerance), q.box))
        add(p, q, intersect(p.spans, q.spans, options), tolerance, contacts);
  return contacts;
}

}  // namespace blossom::occt
