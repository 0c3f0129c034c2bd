// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/pair_search/pair_places.h"

#include <algorithm>
#include <array>

namespace blossom::occt {
namespace {

std::array<Interval, 4> parameters_of(const FaceData& a, const FaceData& b) {
  const auto range = [](const FaceTrims& trims, int k) {
    return Interval{trims.box.low[k] / trims.scale[k], trims.box.high[k] / trims.scale[k]};
  };
  return {range(a.trims, 0), range(a.trims, 1), range(b.trims, 0), range(b.trims, 1)};
}

}  // namespace

Box common_box(const FaceData& a, const FaceData& b) {
  Box common;
  for (int k = 0; k < 3; ++k) {
    common.low[k] = std::max(a.box.low[k], b.box.low[k]);
    common.high[k] = std::min(a.box.high[k], b.box.high[k]);
  }
  return common;
}

double largest_coordinate(const FaceData& a, const FaceData& b) {
  return std::max(
      {max_norm(a.box.low), max_norm(a.box.high), max_norm(b.box.low), max_norm(b.box.high)});
}

Place open_place(const FaceData& a, const FaceData& b) {
  const Box common = common_box(a, b);
  return {PlaceKind::Open, common.low, common.high, 0, diagonal(common), parameters_of(a, b)};
}

Place whole_place(const FaceData& a, const FaceData& b, double gap) {
  return {PlaceKind::Overlap, a.box.low, a.box.high, 0, gap, parameters_of(a, b)};
}

}  // namespace blossom::occt
