// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/intersection/known_curves.h"

#include <algorithm>

namespace blossom {
namespace {

double distance_to_link(const Vec3& p, const Vec3& from, const Vec3& to) {
  const Vec3 step = to - from;
  const double square = dot(step, step);
  const double t = square > 0 ? std::clamp(dot(p - from, step) / square, 0.0, 1.0) : 0.0;
  return distance(p, from + step * t);
}

}  // namespace

KnownCurves::KnownCurves(const std::vector<KnownCurve>& curves, const Vec3& origin) {
  for (const KnownCurve& curve : curves)
    for (std::size_t i = 0; i + 1 < curve.points.size(); ++i)
      links_.push_back({curve.points[i] - origin, curve.points[i + 1] - origin, curve.radius});
}

bool KnownCurves::hold(const Box& box) const {
  const Vec3 middle = 0.5 * (box.low + box.high);
  const double reach = 0.5 * diagonal(box);
  return std::any_of(links_.begin(), links_.end(), [&](const Link& link) {
    return reach <= link.radius &&
           distance_to_link(middle, link.from, link.to) + reach <= link.radius;
  });
}

}  // namespace blossom
