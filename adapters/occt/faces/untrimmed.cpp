// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/faces/untrimmed.h"

#include "adapters/occt/convert/surfaces.h"

namespace blossom::occt {

TrimmedChart trimmed_chart(const FaceTrims& trims) {
  const Vec2 back{1 / trims.scale[0], 1 / trims.scale[1]};  // powers of two
  TrimmedChart chart;
  for (const auto& loop : trims.loops)
    for (const Coedge& coedge : loop)
      chart.borders.push_back({transformed(coedge.curve, back, {}),
                               coedge.reversed(),
                               coedge.from,
                               coedge.to,
                               {},
                               coedge.degenerated});
  for (const Vec2& corner : trims.corners)
    chart.corners.push_back({corner[0] * back[0], corner[1] * back[1]});
  return chart;
}

UntrimmedFace untrimmed(const TopoDS_Face& face, const RegionOptions& options,
                        TriangleLowering& lowering) {
  UntrimmedFace result{bezier_surface(face), {}};
  result.region =
      triangulated_region(result.surface, trimmed_chart(face_trims(face)), options, lowering);
  return result;
}

UntrimmedFace untrimmed(const TopoDS_Face& face, const RegionOptions& options) {
  TriangleLowering lowering;
  return untrimmed(face, options, lowering);
}

}  // namespace blossom::occt
