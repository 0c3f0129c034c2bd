// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/topology/trimmed_chart.h"

namespace blossom {

TrimmedChart trimmed_chart(const FaceTrims& trims) {
  const Vec2 back{1 / trims.scale[0], 1 / trims.scale[1]};  // powers of two
  TrimmedChart chart;
  for (const auto& loop : trims.loops)
    for (const Coedge& coedge : loop)
      chart.borders.push_back({transformed(coedge.curve, back, {}),
                               coedge.reversed,
                               coedge.from,
                               coedge.to,
                               {},
                               coedge.degenerated});
  for (const Vec2& corner : trims.corners)
    chart.corners.push_back({corner[0] * back[0], corner[1] * back[1]});
  return chart;
}

}  // namespace blossom
