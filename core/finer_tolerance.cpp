// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/finer_tolerance.h"

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

bool holds(const Place& place, const SurfaceIntersection& found, double tolerance) {
  for (const SurfacePoint& x : found.points)
    if (meets(place, x.point, x.point, tolerance)) return true;
  for (const IntersectionCurve& curve : found.curves)
    for (std::size_t i = 1; i < curve.samples.size(); ++i) {
      const Vec3 &p = curve.samples[i - 1].point, &q = curve.samples[i].point;
      if (meets(place, p, q, kSagitta * distance(p, q) + tolerance)) return true;
    }
  return false;
}

}  // namespace

bool may_be_settled(const SurfaceIntersection& found, double finer_tolerance) {
  return found.overlaps.empty() && std::ranges::all_of(found.places, [&](const Place& place) {
           return place.kind == PlaceKind::Open || place.kind == PlaceKind::Touch ||
                  place.gap_low <= finer_tolerance;
         });
}

bool is_settled(const SurfaceIntersection& found, const SurfaceIntersection& finer,
                double tolerance, double finer_tolerance) {
  if (finer.status != Status::Complete || !may_be_settled(found, finer_tolerance)) return false;
  return std::ranges::all_of(found.places, [&](const Place& place) {
    const bool is_told = place.kind != PlaceKind::Open && place.gap_low <= finer_tolerance;
    return is_told || holds(place, finer, tolerance);
  });
}

SurfaceIntersection settled(SurfaceIntersection finer) {
  finer.status = Status::Tolerance;
  finer.certificate.reasons.push_back(
      "nearly tangential places were settled at a finer tolerance, without near misses");
  return finer;
}

}  // namespace blossom
