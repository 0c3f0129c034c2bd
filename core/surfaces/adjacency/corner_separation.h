// SPDX-License-Identifier: LGPL-2.1-or-later
// Two cells that come to one point from different sides.
//
// Around a pole, as the tip of a cone, or at a corner, cells have a point in common on every scale,
// so neither boxes nor planes tell them apart. A plane through the point may still have one on
// either side.

#pragma once

#include "core/cells/cell_tree.h"

namespace blossom {

/// True if a plane through a point proves that two cells have nothing in common farther than
/// `reach` from it.
///
/// Control points as near to it as rounding, and a little of the reach, are at the point. Let all
/// others of one cell be at least h above the plane and no farther than D from the point, those of
/// the other cell below it, and what is at the point no more than e off it. What both have in
/// common is no higher than e, so that no more than 2 e / h of it is of points that are not at the
/// point: it is no farther from it than e + 2 e D / h.
///
/// corner     relative to the cells' origin
/// points     control points of a cell, rows times columns
/// reach      model units
bool separated_at(const Vec3& corner, const Cell& a, const Cell& b, int points_a, int points_b,
                  double reach);

}  // namespace blossom
