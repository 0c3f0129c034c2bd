// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/results/contact_places.h"

#include "core/bounds/box_tree.h"

namespace blossom {

Place place_of(const std::vector<SurfacePoint>& points, PlaceKind kind, double gap, double margin) {
  Place place{kind, {}, {}, 0, gap, {}};
  place.parameters.fill({1e300, -1e300});
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

}  // namespace blossom
