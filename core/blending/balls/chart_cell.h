// SPDX-License-Identifier: LGPL-2.1-or-later
// Which patch of a surface a point is in, and its jet by the surface's own parameters.
//
// A curve that runs over a surface is followed patch by patch: inside of one it is analytic, and
// the patch's own polynomials go on a little beside it. Across closed directions parameters go on
// without a jump.

#pragma once

#include <array>
#include <optional>

#include "core/forms/evaluation.h"
#include "core/forms/surface.h"

namespace blossom {

struct ChartCell {
  std::array<int, 2> span{};  ///< in u and v
  Vec2 shift;                 ///< whole periods by which parameters are ahead of the knots
};

/// The cell of a point; on a knot line that after it, outside of the surface the nearest one. In
/// closed directions any parameter has a cell.
ChartCell cell_at(const BezierSurface& surface, const Vec2& uv);

/// The range of a cell in u (0) or v (1), in parameters without jumps.
Interval range_of(const BezierSurface& surface, const ChartCell& cell, int direction);

/// The cell after (+1) or before (-1) in a direction; nothing beyond a border.
std::optional<ChartCell> cell_beside(const BezierSurface& surface, const ChartCell& cell,
                                     int direction, int step);

/// The jet by the surface's own parameters, of the cell's patch even where uv is beside it.
PatchJet chart_jet(const BezierSurface& surface, const ChartCell& cell, const Vec2& uv, int order);

/// True if two neighbouring cells are pieces of one analytic surface near uv, to rounding: their
/// jets agree a tenth of a span away from it to both sides.
bool are_one_piece(const BezierSurface& surface, const ChartCell& a, const ChartCell& b,
                   const Vec2& uv, int direction);

}  // namespace blossom
