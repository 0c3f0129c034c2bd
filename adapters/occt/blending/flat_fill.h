// SPDX-License-Identifier: LGPL-2.1-or-later
// Holes that lie in a plane, closed by a piece of it: those that patches cannot fill, as round
// ones, which have no corners.

#pragma once

#include <optional>
#include <vector>

#include <TopoDS_Face.hxx>

#include "adapters/occt/blending/hole_loop.h"
#include "core/blending/fills/fill_measure.h"
#include "core/blending/fills/fill_side.h"

namespace blossom::occt {

struct FlatFill {
  TopoDS_Face face;                ///< with the edges of the loop, beside their neighbours
  std::vector<FillContact> sides;  ///< how it meets the neighbour of each edge of the loop
  double largest_curvature = 0;    ///< of the neighbours there, 1 / model unit
};

/// The piece of a plane that a loop bounds.
///
/// tolerance   how far edges may be off the plane, model units
/// returns     nothing if the loop lies in no plane, or bounds no valid face, as one that crosses
///             itself
std::optional<FlatFill> flat_fill(const HoleLoop& loop, double tolerance);

}  // namespace blossom::occt
