// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/curves/overlap_place.h"

#include <algorithm>
#include <cstddef>

#include "core/base/unbounded.h"
#include "core/math/interval.h"

namespace blossom {

CurvePlace overlap_place(const CurveTree& curve, const Interval& at, double gap_high) {
  CurvePlace place{PlaceKind::Overlap,
                   {kInfinity, kInfinity, kInfinity},
                   {-kInfinity, -kInfinity, -kInfinity},
                   0,
                   gap_high,
                   at,
                   {}};
  for (int i = 0; i < curve.spans(); ++i) {
    if (!overlap(curve.curve().spans[static_cast<std::size_t>(i)].place, at)) continue;
    for (int k = 0; k < 3; ++k) {
      place.box_low[k] = std::min(place.box_low[k], curve[i].low[k]);
      place.box_high[k] = std::max(place.box_high[k], curve[i].high[k]);
    }
  }
  return place;
}

}  // namespace blossom
