// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/contacts/near_misses.h"

#include <algorithm>
#include <iterator>

#include "core/forms/evaluation.h"
#include "core/math/segment.h"
#include "core/surfaces/contacts/limits.h"
#include "core/surfaces/gap/contact_points.h"

namespace blossom {
namespace {

constexpr double kGrows = 2;         // times, from end to end: no strip of even gap
constexpr double kFootReach = 0.02;  // likewise
// As far as this beyond its end, times what a gap that falls evenly would need to become zero, is
// the branch: a gap that falls ever more slowly, as beside a touch, needs 2.4 times as much.
constexpr double kBranchReach = 3;

class NearMisses {
 public:
  NearMisses(const PairSearchResult& found, SurfaceCells& a, SurfaceCells& b, double tolerance)
      : found_(found), a_(a), b_(b), least_(kRoundingGap * tolerance) {}

  bool hold(const ContactChain& chain) const {
    if (chain.arm_count() > 0 || chain.closed || chain.path.size() < 2) return false;
    const auto& path = chain.path;
    return (chain.leaves[0] && leads_to_branch(path.begin(), path.end())) ||
           (chain.leaves[1] && leads_to_branch(path.rbegin(), path.rend()));
  }

 private:
  static bool is_inside(const Point4& x) {
    return std::ranges::all_of(x, [](double t) { return t > kOnBorder && t < 1 - kOnBorder; });
  }

  Vec3 point(int patch_a, const Point4& x) const {
    return point_at(a_.tree(patch_a).patch(), x[0], x[1]);
  }

  // From the nearer end.
  template <class Iterator>
  bool leads_to_branch(Iterator first, Iterator last) const {
    const auto next_is_closer = [](const ContactPoint& p, const ContactPoint& q) {
      return q.gap <= p.gap;
    };
    const double least = first->gap, most = std::prev(last)->gap;
    if (least <= least_ || most <= kGrows * least || !is_inside(first->x) ||
        std::adjacent_find(first, last, next_is_closer) != last)
      return false;
    double length = 0;
    for (auto p = first; std::next(p) != last; ++p)
      length += distance(point(p->patch_a, p->x), point(std::next(p)->patch_a, std::next(p)->x));
    const double reach = kBranchReach * length * least / (most - least);
    return std::ranges::any_of(
        found_.arcs, [&](const FoundArc& arc) { return falls_towards(arc, *first, reach); });
  }

  bool falls_towards(const FoundArc& arc, const ContactPoint& end, double reach) const {
    if (arc.dropped || arc.patch_a != end.patch_a || arc.patch_b != end.patch_b) return false;
    const Vec3 from = point(arc.patch_a, arc.arc.from), to = point(arc.patch_a, arc.arc.to);
    const Vec3 x = point(end.patch_a, end.x);
    const double part = nearest_part(x, from, to);
    if (distance(x, from + part * (to - from)) > reach) return false;
    Point4 between;
    for (std::size_t k = 0; k < 4; ++k) {
      const double there = (1 - part) * arc.arc.from[k] + part * arc.arc.to[k];
      between[k] = 0.5 * (end.x[k] + there);
    }
    const auto& patch_a = a_.tree(end.patch_a).patch();
    const auto& patch_b = b_.tree(end.patch_b).patch();
    const auto foot = foot_point(patch_a, patch_b, between, kFootReach);
    return foot &&
           distance(point(end.patch_a, *foot), point_at(patch_b, (*foot)[2], (*foot)[3])) < end.gap;
  }

  const PairSearchResult& found_;
  SurfaceCells &a_, &b_;
  const double least_;  // a larger gap is no rounding
};

}  // namespace

void drop_near_misses(std::vector<ContactChain>& chains, const PairSearchResult& found,
                      SurfaceCells& a, SurfaceCells& b, double tolerance) {
  const NearMisses misses(found, a, b, tolerance);
  std::erase_if(chains, [&](const ContactChain& chain) { return misses.hold(chain); });
}

}  // namespace blossom
