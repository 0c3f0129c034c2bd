// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/cells/known_curves.h"

#include <algorithm>

namespace blossom {
namespace {

constexpr int kBoxHalvings = 6;  // of a box; the search halves its cells, too
constexpr std::size_t kRun = 8;

Vec3 corner_of(const Box& box, int corner) {
  Vec3 p;
  for (int k = 0; k < 3; ++k) p[k] = (corner >> k & 1) != 0 ? box.high[k] : box.low[k];
  return p;
}

bool holds(const Box& box, const Vec3& p) {
  for (int k = 0; k < 3; ++k)
    if (p[k] < box.low[k] || p[k] > box.high[k]) return false;
  return true;
}

}  // namespace

KnownCurves::KnownCurves(const std::vector<KnownCurve>& curves, const Vec3& origin) {
  for (const KnownCurve& curve : curves) add(curve, origin);
}

void KnownCurves::add(const KnownCurve& curve, const Vec3& origin) {
  widest_ = std::max(widest_, curve.radius);
  const std::size_t first = capsules_.size();
  for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
    const Vec3 from = curve.points[i] - origin, step = curve.points[i + 1] - curve.points[i];
    const double square = dot(step, step);
    capsules_.push_back({from, step, square > 0 ? 1 / square : 0, curve.radius * curve.radius});
  }
  for (std::size_t i = first; i < capsules_.size(); i += kRun) {
    Run run{{}, i, std::min(i + kRun, capsules_.size())};
    for (std::size_t k = run.first; k < run.last; ++k)
      for (const Vec3& p : {capsules_[k].from, capsules_[k].from + capsules_[k].step})
        run.box = joined(run.box, {p, p});
    run.box = widened(run.box, curve.radius);
    runs_.push_back(run);
  }
}

template <class Wanted>
bool KnownCurves::any_round(const Vec3& p, Wanted wanted) const {
  for (const Run& run : runs_) {
    if (!holds(run.box, p)) continue;
    for (std::size_t i = run.first; i < run.last; ++i)
      if (capsules_[i].holds(p) && wanted(capsules_[i])) return true;
  }
  return false;
}

// Most boxes that are not held have a corner that is not, which the halving of boxes finds late.
bool KnownCurves::hold(const Box& box) const {
  const auto any = [](const Capsule&) { return true; };
  for (int corner = 0; corner < 8; ++corner)
    if (!any_round(corner_of(box, corner), any)) return false;
  return hold(box, kBoxHalvings);
}

// A capsule is convex: it holds a box that has all its corners in it. A long box beside several of
// them is looked at in halves.
bool KnownCurves::hold(const Box& box, int halvings) const {
  const Vec3 middle = 0.5 * (box.low + box.high);
  bool near = false;
  const bool held = any_round(middle, [&](const Capsule& capsule) {
    near = true;
    return capsule.holds(box);
  });
  if (held || !near || halvings == 0) return held;
  const Vec3 sides = box.high - box.low;
  const int longest = sides[0] >= std::max(sides[1], sides[2]) ? 0 : sides[1] >= sides[2] ? 1 : 2;
  Box lower = box, upper = box;
  lower.high[longest] = upper.low[longest] = middle[longest];
  return hold(lower, halvings - 1) && hold(upper, halvings - 1);
}

bool KnownCurves::Capsule::holds(const Box& box) const {
  for (int corner = 0; corner < 8; ++corner)
    if (!holds(corner_of(box, corner))) return false;
  return true;
}

}  // namespace blossom
