// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/results/contact_places.h"

#include "core/base/unbounded.h"
#include "core/bounds/box_tree.h"

namespace blossom {

Place place_of(const std::vector<SurfacePoint>& points, PlaceKind kind, double gap, double margin) {
  Place place{kind, {}, {}, 0, gap, {}};
  place.parameters.fill({kUnbounded, -kUnbounded});
  Box box;
  for (const SurfacePoint& x : points) {
    box = joined(box, {x.point, x.point});
    widen(place, x, gap);
  }
  box = widened(box, margin);
  place.gap_low = 0;
  place.box_low = box.low;
  place.box_high = box.high;
  return place;
}

double contact_reach(const SurfaceIntersection& found, const Vec3& point) {
  constexpr std::array kContacts{PlaceKind::Touch, PlaceKind::Node, PlaceKind::Cusp,
                                 PlaceKind::Pole};
  double reach = 0;
  for (const Place& place : found.places) {
    const Box box{place.box_low, place.box_high};
    if (std::ranges::find(kContacts, place.kind) == kContacts.end() || !meet(box, {point, point}))
      continue;
    for (const Vec3& corner : {box.low, box.high}) reach = std::max(reach, distance(corner, point));
  }
  return reach;
}

}  // namespace blossom
