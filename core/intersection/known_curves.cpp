// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/intersection/known_curves.h"

#include <algorithm>

namespace blossom {
namespace {

constexpr int kHalvings = 6;  // of a box; the search halves its cells, too

double distance_to_link(const Vec3& p, const Vec3& from, const Vec3& to) {
  const Vec3 step = to - from;
  const double square = dot(step, step);
  const double t = square > 0 ? std::clamp(dot(p - from, step) / square, 0.0, 1.0) : 0.0;
  return distance(p, from + step * t);
}

}  // namespace

KnownCurves::KnownCurves(const std::vector<KnownCurve>& curves, const Vec3& origin) {
  for (const KnownCurve& curve : curves) {
    widest_ = std::max(widest_, curve.radius);
    for (std::size_t i = 0; i + 1 < curve.points.size(); ++i)
      links_.push_back({curve.points[i] - origin, curve.points[i + 1] - origin, curve.radius});
  }
}

bool KnownCurves::hold(const Box& box) const { return hold(box, kHalvings); }

// A capsule round a link is convex: it holds a box that has all its corners in it. A long box
// beside several links is looked at in halves.
bool KnownCurves::hold(const Box& box, int halvings) const {
  const Vec3 middle = 0.5 * (box.low + box.high);
  bool near = false;
  for (const Link& link : links_) {
    if (distance_to_link(middle, link.from, link.to) > link.radius) continue;
    if (holds_corners(link, box)) return true;
    near = true;
  }
  if (!near || halvings == 0) return false;
  const Vec3 sides = box.high - box.low;
  const int longest = sides[0] >= std::max(sides[1], sides[2]) ? 0 : sides[1] >= sides[2] ? 1 : 2;
  Box lower = box, upper = box;
  lower.high[longest] = upper.low[longest] = middle[longest];
  return hold(lower, halvings - 1) && hold(upper, halvings - 1);
}

bool KnownCurves::holds_corners(const Link& link, const Box& box) {
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 p;
    for (int k = 0; k < 3; ++k) p[k] = (corner >> k & 1) != 0 ? box.high[k] : box.low[k];
    if (distance_to_link(p, link.from, link.to) > link.radius) return false;
  }
  return true;
}

}  // namespace blossom
