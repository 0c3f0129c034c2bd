// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/wires/exact_meeting.h"

#include <algorithm>
#include <vector>

#include <BRep_Tool.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/faces/elementary_faces.h"
#include "adapters/occt/splitting/edges/edge_stretches.h"
#include "core/base/unbounded.h"

namespace blossom::occt {
namespace {

// A line or circle, put into an elementary surface's equation, gives a polynomial of degree 4 at
// most, or a sum of four harmonics, which has eight zeros: samples are more than these.
constexpr int kRunSamples = 17;

bool is_line_or_circle(const RangedCurve& of) {
  const GeomAbs_CurveType type = GeomAdaptor_Curve(of.curve).GetType();
  return type == GeomAbs_Line || type == GeomAbs_Circle;
}

template <class Gap>
bool holds_along(const Interval& stretch, double within, const Gap& gap) {
  for (int i = 0; i < kRunSamples; ++i)
    if (gap(at(stretch, static_cast<double>(i) / (kRunSamples - 1))) > within) return false;
  return true;
}

// The distance from the edges and corners of a face.
double border_distance(const TopoDS_Face& face, const gp_Pnt& point) {
  double least = kInfinity;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
    if (!BRep_Tool::Degenerated(edge))
      least = std::min(least, foot_on(curve_of(edge), point).distance);
  }
  for (TopExp_Explorer it(face, TopAbs_VERTEX); it.More(); it.Next())
    least = std::min(least, point.Distance(BRep_Tool::Pnt(TopoDS::Vertex(it.Current()))));
  return least;
}

// Each place has to have one of the points or runs in it that are exact.
template <class Found, class Run>
bool explains_all(const Found& found, const std::vector<double>& points,
                  const std::vector<Run>& runs) {
  return std::ranges::all_of(found.places, [&](const CurvePlace& place) {
    const Interval& in = place.a;
    return std::ranges::any_of(points, [&](double t) { return in.from <= t && t <= in.to; }) ||
           std::ranges::any_of(
               runs, [&](const Run& run) { return run.from <= in.to && in.from <= run.to; });
  });
}

}  // namespace

bool ExactMeeting::is_exact(const CurveSurfacePoint& point, const TopoDS_Face& face) const {
  const gp_Pnt here = curve_of(edge_).curve->Value(point.t);
  if (here.Distance(BRep_Tool::Surface(face)->Value(point.uv[0], point.uv[1])) > within_)
    return false;
  const double to_border = border_distance(face, here);
  return to_border <= within_ || to_border > reach_;
}

bool ExactMeeting::lies_in(const TopoDS_Face& face, const SurfaceProjector& feet,
                           const Interval& stretch) const {
  const RangedCurve of = curve_of(edge_);
  if (!is_line_or_circle(of) || !elementary_of(BRep_Tool::Surface(face))) return false;
  return holds_along(stretch, within_, [&](double t) {
    const Vec3 point = vec(of.curve->Value(t));
    return feet.gap(point, feet.foot(point, {}));
  });
}

bool ExactMeeting::lies_along(const TopoDS_Edge& other, const Interval& stretch) const {
  const RangedCurve of = curve_of(edge_), along = curve_of(other);
  if (!is_line_or_circle(of) || !is_line_or_circle(along)) return false;
  return holds_along(stretch, within_,
                     [&](double t) { return foot_on(along, of.curve->Value(t)).distance; });
}

bool ExactMeeting::decides(const CurveSurfaceIntersection& found, const TopoDS_Face& face,
                           const SurfaceProjector& feet) const {
  std::vector<double> points;
  // In a pole of the surface its parameters tell less of the place than the corner there.
  for (TopExp_Explorer it(face, TopAbs_VERTEX); it.More(); it.Next()) {
    const EdgeFoot foot = foot_on(curve_of(edge_), BRep_Tool::Pnt(TopoDS::Vertex(it.Current())));
    if (foot.distance <= within_) points.push_back(foot.parameter);
  }
  for (const CurveSurfacePoint& point : found.points)
    if (!point.proven && is_exact(point, face)) points.push_back(point.t);
  std::vector<Interval> runs;
  for (const CurveSurfaceOverlap& run : found.overlaps)
    if ((run.proven && run.gap_high <= within_) || lies_in(face, feet, run.t))
      runs.push_back(run.t);
  return explains_all(found, points, runs);
}

bool ExactMeeting::decides(const CurveIntersection& found, const TopoDS_Edge& other) const {
  const RangedCurve of = curve_of(edge_), with = curve_of(other);
  std::vector<double> points;
  for (const CurvePoint& point : found.points)
    if (of.curve->Value(point.a).Distance(with.curve->Value(point.b)) <= within_)
      points.push_back(point.a);
  std::vector<Interval> runs;
  for (const CurveOverlap& run : found.overlaps)
    if ((run.proven && run.gap_high <= within_) || lies_along(other, run.a)) runs.push_back(run.a);
  return explains_all(found, points, runs);
}

}  // namespace blossom::occt
