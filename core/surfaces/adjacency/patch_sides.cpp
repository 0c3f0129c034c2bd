// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/adjacency/patch_sides.h"

#include <algorithm>

#include "core/surfaces/adjacency/limits.h"

namespace blossom {
const Vec4& corner_point(const RationalBezierPatch& patch, const Vec2& corner) {
  const Grid<Vec4>& net = patch.points;
  return net(corner[0] > 0 ? net.rows() - 1 : 0, corner[1] > 0 ? net.columns() - 1 : 0);
}

std::vector<Vec4> side_points(const RationalBezierPatch& patch, const PatchSide& side) {
  const Grid<Vec4>& net = patch.points;
  std::vector<Vec4> points;
  if (side.across == 0)
    for (int j = 0; j < net.columns(); ++j)
      points.push_back(net(side.high ? net.rows() - 1 : 0, j));
  else
    for (int i = 0; i < net.rows(); ++i)
      points.push_back(net(i, side.high ? net.columns() - 1 : 0));
  return points;
}

std::vector<PatchSide> outer_sides(const SurfaceCells& cells, int patch) {
  const BezierSurface& surface = cells.surface();
  const std::array at{cells.span_u(patch), cells.span_v(patch)};
  const std::array spans{surface.patches.rows(), surface.patches.columns()};
  const std::array closed{surface.closed_u, surface.closed_v};
  std::vector<PatchSide> sides;
  for (std::size_t k = 0; k < 2; ++k) {
    if (closed[k]) continue;
    if (at[k] == 0) sides.push_back({k, false});
    if (at[k] == spans[k] - 1) sides.push_back({k, true});
  }
  return sides;
}

PoleSide pole_side(const PatchSide& side) {
  return static_cast<PoleSide>(2 * side.across + (side.high ? 1 : 0));
}

std::optional<double> pole_gap(const RationalBezierPatch& patch, const PatchSide& side,
                               const Vec3& pole, double nearest) {
  double gap = 0, largest = max_norm(pole);
  for (const Vec4& p : side_points(patch, side)) {
    gap = std::max(gap, distance(projected(p), pole));
    if (!(gap <= nearest)) return std::nullopt;
    largest = std::max(largest, max_norm(projected(p)));
  }
  return gap + kPointRounding * largest;
}

RationalBezierPatch with_pole(RationalBezierPatch patch, const PatchSide& side, const Vec3& pole) {
  Grid<Vec4>& net = patch.points;
  const auto put = [&](Vec4& p) { p = {p[3] * pole[0], p[3] * pole[1], p[3] * pole[2], p[3]}; };
  const int row = side.high ? net.rows() - 1 : 0, column = side.high ? net.columns() - 1 : 0;
  if (side.across == 0)
    for (int j = 0; j < net.columns(); ++j) put(net(row, j));
  else
    for (int i = 0; i < net.rows(); ++i) put(net(i, column));
  return patch;
}

}  // namespace blossom
