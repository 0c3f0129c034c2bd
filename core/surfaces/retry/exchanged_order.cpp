// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/retry/exchanged_order.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/forms/evaluation.h"
#include "core/surfaces/pairs/border_roots.h"

namespace blossom {
namespace {

constexpr double kApart = 1e-5;               // of the tolerance: a gap that is no rounding
constexpr double kOnBorder = 2 * kSamePoint;  // of a span, as where chains end

bool is_on_border(const BezierSurface& surface, const Vec2& uv) {
  const auto at_end = [](const std::vector<double>& knots, double x) {
    const std::size_t last = knots.size() - 1;
    return std::abs(x - knots[0]) <= kOnBorder * (knots[1] - knots[0]) ||
           std::abs(x - knots[last]) <= kOnBorder * (knots[last] - knots[last - 1]);
  };
  return at_end(surface.u_knots, uv[0]) || at_end(surface.v_knots, uv[1]);
}

void exchange(SurfacePoint& x) { std::swap(x.uv_a, x.uv_b); }

void exchange(Place& place) {
  std::swap(place.parameters[0], place.parameters[2]);
  std::swap(place.parameters[1], place.parameters[3]);
}

// An end on the borders of both surfaces is said to be on that of the first one.
CurveEnd exchanged(CurveEnd end, const SurfacePoint& x, const BezierSurface& a) {
  if (end == CurveEnd::BorderB) return CurveEnd::BorderA;
  if (end == CurveEnd::BorderA && !is_on_border(a, x.uv_a)) return CurveEnd::BorderB;
  return end;
}

void exchange(IntersectionCurve& curve, const BezierSurface& a) {
  std::swap(curve.chart_a, curve.chart_b);
  std::swap(curve.deviation.a, curve.deviation.b);
  for (SurfacePoint& x : curve.samples) exchange(x);
  if (curve.samples.empty()) return;
  curve.ends = {exchanged(curve.ends[0], curve.samples.front(), a),
                exchanged(curve.ends[1], curve.samples.back(), a)};
}

// The cosine between the normals of two surfaces that coincide on one side of a point at least:
// beyond a kink there they do not.
double common_cosine(const BezierSurface& a, const BezierSurface& b, const SurfacePoint& x) {
  double best = 0;
  for (const Vec3& p : one_sided_normals(a, x.uv_a))
    for (const Vec3& q : one_sided_normals(b, x.uv_b)) {
      const double cosine = dot(unit(p), unit(q));
      if (std::abs(cosine) > std::abs(best)) best = cosine;
    }
  return best;
}

// The sense of its boundary follows the normal of the first surface. Normals are parallel all along
// it, up to their sign, or have no length. Where a kink turns back altogether that does not tell
// the sign, but no straight part of a closed line is half of it.
void exchange(Overlap& overlap, const BezierSurface& a, const BezierSurface& b) {
  double alike = 0;
  Vec3 last;
  for (SurfacePoint& x : overlap.boundary) {
    exchange(x);
    if (&x != &overlap.boundary.front()) alike += distance(last, x.point) * common_cosine(a, b, x);
    last = x.point;
  }
  if (alike < 0) std::ranges::reverse(overlap.boundary);
}

bool is_cusp(const Place& place) { return place.kind == PlaceKind::Cusp; }

bool is_closed(const IntersectionCurve& curve) {
  return curve.samples.size() > 1 && curve.samples.front().point == curve.samples.back().point;
}

}  // namespace

SurfaceIntersection exchanged(SurfaceIntersection found, const BezierSurface& a,
                              const BezierSurface& b) {
  for (Overlap& overlap : found.overlaps) exchange(overlap, a, b);
  for (IntersectionCurve& curve : found.curves) exchange(curve, a);
  for (SurfacePoint& x : found.points) exchange(x);
  for (SurfacePoint& x : found.nodes) exchange(x);
  for (Place& place : found.places) exchange(place);
  return found;
}

bool should_retry_swapped(const SurfaceIntersection& found, const BezierSurface& a,
                          const BezierSurface& b, double tolerance) {
  if (found.status == Status::Stopped) return !found.certificate.limited;
  if (found.status == Status::Complete || !found.overlaps.empty()) return false;
  const auto is_touch = [](const Place& place) { return place.kind == PlaceKind::Touch; };
  const auto is_apart = [&](const SurfacePoint& x) {
    return distance(point_at(a, x.uv_a), point_at(b, x.uv_b)) > kApart * tolerance;
  };
  if (std::ranges::any_of(found.places, is_cusp) && std::ranges::any_of(found.curves, is_closed))
    return true;
  return std::ranges::all_of(found.places, is_touch) && std::ranges::any_of(found.points, is_apart);
}

bool is_gain(const SurfaceIntersection& found, const SurfaceIntersection& other) {
  return weaker(found.status, other.status) != other.status;
}

}  // namespace blossom
