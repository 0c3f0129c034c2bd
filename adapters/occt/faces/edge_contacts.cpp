// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/faces/edge_contacts.h"

#include <algorithm>

#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>

#include "adapters/occt/curves.h"
#include "adapters/occt/errors.h"
#include "adapters/occt/forms/edge_charts.h"
#include "core/bounds/box_tree.h"
#include "core/curve_intersection.h"

namespace blossom::occt {
namespace {

// An edge of a face, in space and in the face's parameters.
struct Outline {
  CurveSpans spans;
  Handle(Geom2d_Curve) chart;
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
    outlines.push_back({bezier_spans(curve, range), chart, {}});
    outlines.back().box = box_of(outlines.back().spans);
  }
  return outlines;
}

Vec2 value(const Handle(Geom2d_Curve) & chart, double t) {
  const gp_Pnt2d p = chart->Value(t);
  return {p.X(), p.Y()};
}

}  // namespace

std::vector<SurfacePoint> edge_contacts(const TopoDS_Face& a, const TopoDS_Face& b,
                                        double tolerance) {
  IntersectionOptions options;
  options.tolerances.point = tolerance;
  std::vector<SurfacePoint> contacts;
  const std::vector<Outline> all_b = outlines_of(b);
  for (const Outline& p : outlines_of(a))
    for (const Outline& q : all_b) {
      if (!meet(widened(p.box, tolerance), q.box)) continue;
      for (const CurvePoint& x : intersect(p.spans, q.spans, options).points) {
        const bool known =
            std::any_of(contacts.begin(), contacts.end(), [&](const SurfacePoint& other) {
              return distance(other.point, x.point) <= 2 * tolerance;
            });
        if (!known) contacts.push_back({x.point, value(p.chart, x.a), value(q.chart, x.b)});
      }
    }
  return contacts;
}

}  // namespace blossom::occt
