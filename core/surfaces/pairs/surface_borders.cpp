// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/pairs/surface_borders.h"

namespace blossom {

SurfaceBorders upper_borders(const SurfaceCells& a, int patch_a, const Cell& cell_a,
                             const SurfaceCells& b, int patch_b, const Cell& cell_b) {
  const auto last = [](const Interval& place, int span, int spans, bool closed) {
    return place.to == 1 && span == spans - 1 && !closed;
  };
  const BezierSurface &sa = a.surface(), &sb = b.surface();
  return {{last(cell_a.u, a.span_u(patch_a), sa.patches.rows(), sa.closed_u),
           last(cell_a.v, a.span_v(patch_a), sa.patches.columns(), sa.closed_v),
           last(cell_b.u, b.span_u(patch_b), sb.patches.rows(), sb.closed_u),
           last(cell_b.v, b.span_v(patch_b), sb.patches.columns(), sb.closed_v)}};
}

}  // namespace blossom
