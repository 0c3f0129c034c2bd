// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/balls/extended_surface.h"

#include <cstddef>
#include <utility>

#include "core/subdivision/patch_subdivision.h"

namespace blossom {
namespace {

bool has_positive_weights(const RationalBezierPatch& patch) {
  for (int i = 0; i < patch.points.rows(); ++i)
    for (int k = 0; k < patch.points.columns(); ++k)
      if (!(patch.points(i, k)[3] > 0)) return false;
  return true;
}

// The patches of one more row or column, beyond the first or the last one.
struct Beyond {
  bool in_u = true;
  bool first = true;
  Interval local;  // of the outer patches

  int count(const BezierSurface& of) const {
    return in_u ? of.patches.columns() : of.patches.rows();
  }
  const RationalBezierPatch& outer(const BezierSurface& of, int k) const {
    const int last = (in_u ? of.patches.rows() : of.patches.columns()) - 1;
    return in_u ? of.patches(first ? 0 : last, k) : of.patches(k, first ? 0 : last);
  }
  RationalBezierPatch patch(const BezierSurface& of, int k) const {
    constexpr Interval kWhole{0, 1};
    return sub_patch(outer(of, k), in_u ? local : kWhole, in_u ? kWhole : local);
  }
};

void extend(BezierSurface& surface, bool in_u, bool first, double part) {
  const ParameterLaw law = in_u ? surface.u_law : surface.v_law;
  if (part <= 0 || law != ParameterLaw::Linear || (in_u ? surface.closed_u : surface.closed_v))
    return;
  const Beyond beyond{in_u, first, first ? Interval{-part, 0} : Interval{1, 1 + part}};
  const int rows = surface.patches.rows(), columns = surface.patches.columns();
  Grid<RationalBezierPatch> grown(rows + (in_u ? 1 : 0), columns + (in_u ? 0 : 1));
  const int row_shift = in_u && first ? 1 : 0, column_shift = !in_u && first ? 1 : 0;
  for (int k = 0; k < beyond.count(surface); ++k) {
    RationalBezierPatch patch = beyond.patch(surface, k);
    if (!has_positive_weights(patch)) return;
    const int place = first ? 0 : (in_u ? rows : columns);
    (in_u ? grown(place, k) : grown(k, place)) = std::move(patch);
  }
  for (int i = 0; i < rows; ++i)
    for (int k = 0; k < columns; ++k)
      grown(i + row_shift, k + column_shift) = std::move(surface.patches(i, k));
  surface.patches = std::move(grown);
  std::vector<double>& knots = in_u ? surface.u_knots : surface.v_knots;
  const std::size_t last = knots.size() - 1;
  if (first)
    knots.insert(knots.begin(), knots[0] - part * (knots[1] - knots[0]));
  else
    knots.push_back(knots[last] + part * (knots[last] - knots[last - 1]));
}

}  // namespace

BezierSurface extended(const BezierSurface& surface, const std::array<double, 2>& u_parts,
                       const std::array<double, 2>& v_parts) {
  BezierSurface made = surface;
  extend(made, true, true, u_parts[0]);
  extend(made, true, false, u_parts[1]);
  extend(made, false, true, v_parts[0]);
  extend(made, false, false, v_parts[1]);
  return made;
}

}  // namespace blossom
