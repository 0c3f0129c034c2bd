// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/fills/fill_side.h"

#include <algorithm>
#include <cmath>

namespace blossom {
namespace {

/// The same curve, and neighbour, with weight 1 at both ends: scaled, then weights by powers of a
/// factor, which changes the parameter by a projective map.
void normalize_weights(FillSide& side) {
  const double first = side.edge.front()[3], last = side.edge.back()[3];
  if (first == 1 && last == 1) return;
  const std::size_t size = std::max({side.edge.size(), side.across.size(), side.bend.size()});
  for (Row* const row : {&side.edge, &side.across, &side.bend}) {
    if (row->empty()) continue;
    *row = raised(*row, static_cast<int>(size) - 1);
    const double ratio = std::pow(first / last, 1 / static_cast<double>(size - 1));
    double factor = 1 / first;
    for (Vec4& p : *row) {
      p *= factor;
      factor *= ratio;
    }
  }
  for (Vec4* const end : {&side.edge.front(), &side.edge.back()}) (*end)[3] = 1;
}

/// Moves `origin` to 0 and makes `size` 1.
void place(FillSide& side, const Vec3& origin, double size) {
  for (Row* const row : {&side.edge, &side.across, &side.bend})
    for (Vec4& p : *row)
      for (int x = 0; x < 3; ++x) p[x] = (p[x] - origin[x] * p[3]) / size;
}

}  // namespace

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

PreparedSides prepared(const std::vector<FillSide>& sides) {
  PreparedSides result{.sides = sides, .in_place = {}, .origin = {}, .size = 0};
  for (FillSide& side : result.sides) {
    normalize_weights(side);
    result.origin += (1.0 / static_cast<double>(sides.size())) * projected(side.edge.front());
  }
  result.in_place = result.sides;
  for (const FillSide& side : result.sides)
    for (const Vec4& p : side.edge)
      result.size = std::max(result.size, distance(projected(p), result.origin));
  for (FillSide& side : result.sides) place(side, result.origin, result.size);
  for (std::size_t k = 0; k < sides.size(); ++k) {
    Vec4& end = result.sides[(k + sides.size() - 1) % sides.size()].edge.back();
    Vec4& start = result.sides[k].edge.front();
    start = end = 0.5 * (start + end);
  }
  return result;
}

}  // namespace blossom
