// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/results/result_places.h"

#include <algorithm>

#include "core/math/segment.h"

namespace blossom {
bool is_known_contact(const SurfaceIntersection& result, const Vec3& point, double reach) {
  return std::ranges::any_of(
      result.points, [&](const SurfacePoint& p) { return distance(p.point, point) <= reach; });
}

bool is_on_curve(const SurfaceIntersection& result, const Vec3& point, double reach,
                 bool tangential_only) {
  return std::ranges::any_of(result.curves, [&](const IntersectionCurve& curve) {
    if (tangential_only && !curve.tangential) return false;
    for (std::size_t i = 0; i + 1 < curve.samples.size(); ++i)
      if (segment_gap(point, curve.samples[i].point, curve.samples[i + 1].point) <= reach)
        return true;
    return false;
  });
}

bool has_overlap(const SurfaceIntersection& result) {
  return std::ranges::any_of(result.places,
                             [](const Place& place) { return place.kind == PlaceKind::Overlap; });
}

bool ends_curve(const SurfaceIntersection& result, const Vec3& point, double reach) {
  return std::ranges::any_of(result.curves, [&](const IntersectionCurve& curve) {
    return distance(curve.samples.front().point, point) <= reach ||
           distance(curve.samples.back().point, point) <= reach;
  });
}

bool bounds_overlap(const SurfaceIntersection& result, const Vec3& point, double reach) {
  return std::ranges::any_of(result.overlaps, [&](const Overlap& overlap) {
    return std::ranges::any_of(
        overlap.boundary, [&](const SurfacePoint& p) { return distance(p.point, point) <= reach; });
  });
}

}  // namespace blossom
