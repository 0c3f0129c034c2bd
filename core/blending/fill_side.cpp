// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/fill_side.h"

namespace blossom {

FillSide fill_side(const RationalBezierPatch& patch, SurfaceSide side, bool backward,
                   FillContinuity continuity) {
  const bool along_v = side == SurfaceSide::UMin || side == SurfaceSide::UMax;
  const bool at_end = side == SurfaceSide::UMax || side == SurfaceSide::VMax;
  const int along = along_v ? patch.degree_v() : patch.degree_u();
  const int m = along_v ? patch.degree_u() : patch.degree_v();
  FillSide result{.edge = {}, .across = {}, .bend = {}, .continuity = continuity};
  for (int k = 0; k <= along; ++k) {
    const int i = backward ? along - k : k;
    const auto at = [&](int depth) {
      const int j = at_end ? m - depth : depth;
      return along_v ? patch.points(j, i) : patch.points(i, j);
    };
    result.edge.push_back(at(0));
    result.across.push_back(static_cast<double>(m) * (at(1) - at(0)));
    result.bend.push_back(m < 2 ? Vec4{}
                                : static_cast<double>(m * (m - 1)) * (at(2) - 2 * at(1) + at(0)));
  }
  return result;
}

bool is_rational(const std::vector<FillSide>& sides) {
  for (const FillSide& side : sides) {
    for (const Vec4& p : side.edge)
      if (p[3] != 1) return true;
    for (const Row* const row : {&side.across, &side.bend})
      for (const Vec4& p : *row)
        if (p[3] != 0) return true;
  }
  return false;
}

}  // namespace blossom
