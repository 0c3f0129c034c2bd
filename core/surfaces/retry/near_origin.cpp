// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/retry/near_origin.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace blossom {
namespace {

// Of the tolerance: what coordinates may be rounded to. A choice; nothing is lost by moving more.
constexpr double kSmallRounding = 1e-4;

// Of points that are no farther than twice the origin, by adding it: half a unit in the last place
// of each coordinate.
double rounding_at(const Vec3& origin) {
  return std::numeric_limits<double>::epsilon() * 2 * norm(origin);
}

void move(std::vector<SurfacePoint>& points, const Vec3& by) {
  for (SurfacePoint& x : points) x.point += by;
}

void move(IntersectionCurve& curve, const Vec3& by) {
  const double rounding = rounding_at(by);
  for (Vec3& point : curve.curve.points) point += by;
  if (curve.conic) {
    curve.conic->centre += by;
    curve.deviation.conic += 2 * rounding;
  }
  move(curve.samples, by);
  curve.deviation.a += rounding;
  curve.deviation.b += rounding;
}

}  // namespace

Vec3 far_origin(const Box& box, double tolerance) {
  Vec3 origin;
  for (int k = 0; k < 3; ++k) {
    const auto [least, most] = std::minmax({std::abs(box.low[k]), std::abs(box.high[k])});
    const bool is_far = most * std::numeric_limits<double>::epsilon() > kSmallRounding * tolerance;
    if (is_far && box.low[k] * box.high[k] > 0 && most <= 2 * least)
      origin[k] = 0.5 * (box.low[k] + box.high[k]);
  }
  return origin;
}

BezierSurface seen_from(const Vec3& origin, BezierSurface surface) {
  for (RationalBezierPatch& patch : surface.patches.values())
    for (Vec4& point : patch.points.values())
      for (int k = 0; k < 3; ++k) point[k] = std::fma(-origin[k], point[3], point[k]);
  return surface;
}

IntersectionOptions seen_from(const Vec3& origin, IntersectionOptions options) {
  for (KnownCurve& curve : options.known)
    for (Vec3& point : curve.points) point -= origin;
  return options;
}

SurfaceIntersection moved_back(const Vec3& origin, SurfaceIntersection found) {
  const double rounding = rounding_at(origin);
  const Vec3 margin{rounding, rounding, rounding};
  for (IntersectionCurve& curve : found.curves) move(curve, origin);
  move(found.points, origin);
  move(found.nodes, origin);
  for (Overlap& overlap : found.overlaps) move(overlap.boundary, origin);
  for (Place& place : found.places) {
    place.box_low += origin - margin;
    place.box_high += origin + margin;
  }
  return found;
}

}  // namespace blossom
