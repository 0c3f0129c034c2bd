// SPDX-License-Identifier: LGPL-2.1-or-later
// What a neighbour gives to a side of a hole.

#pragma once

#include <vector>

#include "core/blending/border_rows.h"
#include "core/blending/fills/fill_conditions.h"
#include "core/forms/patch.h"

namespace blossom {

/// One side of the hole, from corner k to corner k + 1, as a neighbour C(s, t) has it at t = 0.
struct FillSide {
  Row edge;    ///< C
  Row across;  ///< C_t, away from the hole; empty if there is no neighbour
  Row bend;    ///< C_tt; empty if it is not known
  FillContinuity continuity = FillContinuity::G1;
};

/// The side that a border of a patch is. `backward` runs against the patch's parameter.
FillSide fill_side(const RationalBezierPatch& patch, SurfaceSide side, bool backward,
                   FillContinuity continuity);

/// Whether a weight differs from 1 on some side.
bool is_rational(const std::vector<FillSide>& sides);

/// Sides with weight 1 at all corners, moved to the origin and scaled to unit size; the corners
/// agree bit for bit.
struct PreparedSides {
  std::vector<FillSide> sides;
  std::vector<FillSide> in_place;  ///< model units, corners where the caller had them
  Vec3 origin;
  double size = 1;
};

PreparedSides prepared(const std::vector<FillSide>& sides);

}  // namespace blossom
