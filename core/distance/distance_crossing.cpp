// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/distance.h"

#include <algorithm>

#include "core/distance/distance_parts.h"
#include "core/distance/nearest_pair.h"
#include "core/distance/proven_crossing.h"

namespace blossom {
namespace {

// A patch that comes within a distance of a point, and where.
struct NearItem {
  const DistanceItem* item = nullptr;
  Vec2 at;
};

std::vector<NearItem> items_near(const DistanceParts& parts, int part, const Vec3& point,
                                 double within) {
  const RationalBezierPatch as_patch{Grid<Vec4>(2, 2, {point[0], point[1], point[2], 1})};
  std::vector<NearItem> near;
  parts.item_tree(part).for_each_near(point, within * within, [&](int i) {
    const DistanceItem& item = parts.items(part)[static_cast<std::size_t>(i)];
    if (item.dimension() == 2) {
      const NearPair foot = near_pair({&as_patch, 0}, {&item.patch}, {}, {0.5, 0.5});
      if (distance(foot.point_b, point) <= within) near.push_back({&item, foot.b});
    }
    return within * within;
  });
  return near;
}

// Whether a rectangle of a patch, with as much room round it, is inside of the patch and its trims.
bool is_inside(const DistanceParts& parts, int part, const DistanceItem& item, const Interval& u,
               const Interval& v, double room) {
  const PatchJet jet = jet_at(item.patch, (u.from + u.to) / 2, (v.from + v.to) / 2, 1);
  // At a singular point there is room without end in parameters.
  const double room_u = room > 0 ? room / norm(jet.u) : 0;
  const double room_v = room > 0 ? room / norm(jet.v) : 0;
  const Vec2 low{u.from - room_u, v.from - room_v}, high{u.to + room_u, v.to + room_v};
  if (std::min(low[0], low[1]) < 0 || std::max(high[0], high[1]) > 1) return false;
  return parts.side(part, item, low, high) == TrimSide::Inside;
}

}  // namespace

bool proven_to_cross(const PreparedSet& a, int part_a, const PreparedSet& b, int part_b,
                     const Vec3& point, double within, double room) {
  const DistanceParts &of_a = *a.parts_, &of_b = *b.parts_;
  const int i = part_a + of_a.points(), j = part_b + of_b.points();
  if (!of_a.is_exact(i) || !of_b.is_exact(j)) return false;
  const std::vector<NearItem> near_b = items_near(of_b, j, point, within);
  for (const NearItem& p : items_near(of_a, i, point, within))
    for (const NearItem& q : near_b) {
      const auto counts = [&](const Box4& x) {
        return is_inside(of_a, i, *p.item, x[0], x[1], room) &&
               is_inside(of_b, j, *q.item, x[2], x[3], room);
      };
      if (proven_crossing(p.item->patch, q.item->patch, {p.at[0], p.at[1], q.at[0], q.at[1]},
                          counts))
        return true;
    }
  return false;
}

}  // namespace blossom
