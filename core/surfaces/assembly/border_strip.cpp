// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/assembly/border_strip.h"

#include <algorithm>

#include "core/base/unbounded.h"
#include "core/surfaces/branches/found_places.h"

namespace blossom {

bool BorderStrip::holds(const Vec3& point) const {
  return std::any_of(boxes.begin(), boxes.end(), [&](const Box& box) {
    return meet(box, {point, point});
  });
}

BorderStrip border_strip(const SurfaceCells& a, const SurfaceCells& b, const Vec3& origin,
                         const std::vector<CriticalPair>& pairs, double tolerance) {
  BorderStrip strip{{}, {PlaceKind::Tangential, {}, {}, 0, tolerance, {}}};
  strip.place.parameters.fill({kUnbounded, -kUnbounded});
  Box all;
  for (const CriticalPair& pair : pairs) {
    strip.boxes.push_back({pair.low + origin, pair.high + origin});
    all = joined(all, strip.boxes.back());
    widen(strip.place, parameters_of(a, b, pair));
  }
  strip.place.box_low = all.low;
  strip.place.box_high = all.high;
  return strip;
}

}  // namespace blossom
