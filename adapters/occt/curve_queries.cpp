// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/curve_queries.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "adapters/occt/convert/curves.h"
#include "adapters/occt/convert/surfaces.h"
#include "adapters/occt/faces/face_trims.h"
#include "core/curves/curve_closing.h"

namespace blossom::occt {
namespace {

// Of the point tolerance; how well curves that are no splines are approximated.
constexpr double kApproximation = 0.1;

double approximation(const IntersectionOptions& options) {
  return kApproximation * options.tolerances.point;
}

enum class Side { Inside, Border, Outside };

// Whether the face goes on beyond an edge, which it uses twice, as a closed surface's seam.
bool is_seam(const FaceTrims& trims, int edge) {
  std::ptrdiff_t uses = 0;
  for (const auto& loop : trims.loops) uses += std::ranges::count(loop, edge, &Coedge::edge);
  return uses > 1;
}

Side side_of(const FaceTrims& trims, const Vec2& uv, double tolerance) {
  const Vec2 point{uv[0] * trims.scale[0], uv[1] * trims.scale[1]};
  bool on_seam = false;
  for (const auto& loop : trims.loops)
    for (const Coedge& coedge : loop) {
      if (nearest(coedge.curve, point).distance > tolerance) continue;
      if (coedge.degenerated || !is_seam(trims, coedge.edge)) return Side::Border;
      on_seam = true;
    }
  return on_seam || is_inside(trims, point) ? Side::Inside : Side::Outside;
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
  std::vector<CurvePlace> on_wires;
  for (const CurveSurfacePoint& point : found.points) {
    const Side side = side_of(trims, point.uv, options.tolerances.point);
    if (side == Side::Outside) {
      std::erase_if(found.places, [&](const CurvePlace& place) { return holds(place, point); });
      continue;
    }
    kept.push_back(point);
    if (side == Side::Border && point.proven) {
      kept.back().proven = false;
      on_wires.push_back(border_place(point, options.tolerances.point));
    }
  }
  found.points = std::move(kept);
  const bool contacts = !found.places.empty();
  found.places.insert(found.places.end(), on_wires.begin(), on_wires.end());
  if (found.status == Status::Stopped) return found;
  std::vector<std::string>& reasons = found.certificate.reasons;
  if (!contacts) std::erase(reasons, kContactsWithinTolerance);  // they were outside of the trims
  if (!on_wires.empty()) reasons.emplace_back(kPointsOnWires);
  found.status = reasons.empty() ? Status::Complete : Status::Tolerance;
  return found;
}

}  // namespace blossom::occt
