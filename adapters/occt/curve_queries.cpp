// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/curve_queries.h"

#include <algorithm>

#include <BRep_Tool.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <GeomAPI.hxx>
#include <gp.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/curves.h"
#include "adapters/occt/convert/surfaces.h"
#include "adapters/occt/faces/face_trims.h"

namespace blossom::occt {
namespace {

// Of the point tolerance; how well curves that are no splines are approximated.
constexpr double kApproximation = 0.1;

double approximation(const IntersectionOptions& options) {
  return kApproximation * options.tolerances.point;
}

// (wx, wy, 0, w); numbers that are not finite are refused where curves are checked.
RationalBezierCurve points_of(const Geom2d_BezierCurve& curve) {
  RationalBezierCurve result;
  result.points.reserve(static_cast<std::size_t>(curve.NbPoles()));
  for (int i = 1; i <= curve.NbPoles(); ++i) {
    const gp_Pnt2d p = curve.Pole(i);
    const double w = curve.Weight(i);
    result.points.push_back({w * p.X(), w * p.Y(), 0, w});
  }
  return result;
}

enum class Side { Inside, Border, Outside };

Side side_of(const FaceTrims& trims, const Vec2& uv, double tolerance) {
  const Vec2 point{uv[0] * trims.scale[0], uv[1] * trims.scale[1]};
  for (const auto& loop : trims.loops)
    for (const Coedge& coedge : loop)
      if (nearest(coedge.curve, point).distance <= tolerance) return Side::Border;
  return is_inside(trims, point) ? Side::Inside : Side::Outside;
}

bool holds(const CurvePlace& place, const CurveSurfacePoint& point) {
  return place.kind != PlaceKind::Overlap && place.a.from <= point.t && point.t <= place.a.to;
}

// A point on a wire may lie on either side of it.
CurvePlace border_place(const CurveSurfacePoint& point, double tolerance) {
  const Vec3 reach{tolerance, tolerance, tolerance};
  return {PlaceKind::Touch,
          point.point - reach,
          point.point + reach,
          0,
          tolerance,
          point.box_t,
          {0, 0}};
}

}  // namespace

CurveSpans bezier_spans(const Handle(Geom2d_Curve) & curve, const Interval& range,
                        double tolerance) {
  if (curve.IsNull()) throw BadModel("there is no curve in the plane");
  // Bezier curves go without the detour, which takes longer than an intersection.
  const auto bezier = Handle(Geom2d_BezierCurve)::DownCast(curve);
  if (!bezier.IsNull() && range == Interval{0, 1}) return curve_spans(points_of(*bezier));
  const Handle(Geom_Curve) lifted = guarded(
      "lifting a curve into space", [&] { return GeomAPI::To3d(curve, gp_Pln(gp::XOY())); });
  return bezier_spans(lifted, range, tolerance);
}

CurveSpans bezier_spans(const TopoDS_Edge& edge, double tolerance) {
  Interval range;
  if (edge.IsNull()) throw BadModel("there is no edge");
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, range.from, range.to);
  if (curve.IsNull()) throw BadModel("an edge has no curve in space");
  return bezier_spans(curve, range, tolerance);
}

CurveIntersection intersect(const TopoDS_Edge& a, const TopoDS_Edge& b,
                            const IntersectionOptions& options) {
  const double tolerance = approximation(options);
  return blossom::intersect(bezier_spans(a, tolerance), bezier_spans(b, tolerance), options);
}

CurveIntersection self_intersections(const TopoDS_Edge& edge, const IntersectionOptions& options) {
  return blossom::self_intersections(bezier_spans(edge, approximation(options)), options);
}

CurveSurfaceIntersection intersect(const TopoDS_Edge& edge, const TopoDS_Face& face,
                                   const IntersectionOptions& options) {
  const double tolerance = approximation(options);
  CurveSurfaceIntersection found =
      blossom::intersect(bezier_spans(edge, tolerance), bezier_surface(face, tolerance), options);
  const FaceTrims trims = face_trims(face);
  std::vector<CurveSurfacePoint> kept;
  for (const CurveSurfacePoint& point : found.points) {
    const Side side = side_of(trims, point.uv, options.tolerances.point);
    if (side == Side::Outside) {
      std::erase_if(found.places, [&](const CurvePlace& place) { return holds(place, point); });
      continue;
    }
    kept.push_back(point);
    if (side == Side::Border && point.proven) {
      kept.back().proven = false;
      found.places.push_back(border_place(point, options.tolerances.point));
    }
  }
  found.points = std::move(kept);
  if (found.status == Status::Stopped) return found;
  const bool exact = found.places.empty();
  const bool approximate = found.status == Status::Tolerance &&
                           found.certificate.reasons.size() > 0 &&
                           found.certificate.reasons.back() != "contacts within tolerance";
  found.status = exact && !approximate ? Status::Complete : Status::Tolerance;
  if (!exact && found.certificate.reasons.empty())
    found.certificate.reasons.push_back("points on a wire of the face");
  return found;
}

}  // namespace blossom::occt
