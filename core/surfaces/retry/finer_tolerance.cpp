// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/retry/finer_tolerance.h"

#include <algorithm>
#include <cstddef>

namespace blossom {
namespace {

// How far a curve may be off the chord between two samples, as part of it.
constexpr double kSagitta = 0.1;

bool meets(const Place& place, const Vec3& p, const Vec3& q, double margin) {
  for (int k = 0; k < 3; ++k)
    if (std::max(p[k], q[k]) + margin < place.box_low[k] ||
        std::min(p[k], q[k]) - margin > place.box_high[k])
      return false;
  return true;
}

// A point of a curve, or a lone one, in the place: near misses lie beside curves, too.
bool holds_point(const Place& place, const SurfaceIntersection& found, double tolerance) {
  const auto is_in = [&](const SurfacePoint& x) {
    return meets(place, x.point, x.point, tolerance);
  };
  return std::ranges::any_of(found.points, is_in) ||
         std::ranges::any_of(found.curves, [&](const IntersectionCurve& curve) {
           return std::ranges::any_of(curve.samples, is_in);
         });
}

// The same, or a curve that may pass through.
bool may_hold(const Place& place, const SurfaceIntersection& found, double tolerance) {
  if (holds_point(place, found, tolerance)) return true;
  for (const IntersectionCurve& curve : found.curves)
    for (std::size_t i = 1; i < curve.samples.size(); ++i) {
      const Vec3 &p = curve.samples[i - 1].point, &q = curve.samples[i].point;
      if (meets(place, p, q, kSagitta * distance(p, q) + tolerance)) return true;
    }
  return false;
}

// A curve that was cut beside a node is whole where no node is left, whatever touches elsewhere.
bool decides(const SurfaceIntersection& finer, const SurfaceIntersection& found) {
  return finer.status == Status::Complete ||
         (ends_beside_node(found) && finer.status == Status::Tolerance && finer.nodes.empty());
}

}  // namespace

bool ends_beside_node(const SurfaceIntersection& found) { return found.certificate.beside_node; }

bool may_be_settled(const SurfaceIntersection& found, double finer_tolerance) {
  return found.overlaps.empty() &&
         std::ranges::all_of(found.places,
                             [&](const Place& place) {
                               return place.kind == PlaceKind::Open ||
                                      place.kind == PlaceKind::Touch ||
                                      place.gap_low <= finer_tolerance;
                             }) &&
         std::ranges::any_of(found.places, [&](const Place& place) {
           return place.kind != PlaceKind::Touch || place.gap_low > finer_tolerance;
         });
}

bool is_settled(const SurfaceIntersection& found, const SurfaceIntersection& finer,
                double tolerance, double finer_tolerance) {
  if (!decides(finer, found) || !may_be_settled(found, finer_tolerance)) return false;
  return std::ranges::all_of(found.places, [&](const Place& place) {
    if (place.kind == PlaceKind::Open) return may_hold(place, finer, tolerance);
    return place.gap_low <= finer_tolerance || holds_point(place, finer, tolerance);
  });
}

SurfaceIntersection settled(SurfaceIntersection finer) {
  finer.status = Status::Tolerance;
  finer.certificate.reasons.push_back(
      "nearly tangential contacts were decided at a finer tolerance, without near misses");
  return finer;
}

}  // namespace blossom
