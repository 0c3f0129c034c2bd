// SPDX-License-Identifier: LGPL-2.1-or-later
// Where surfaces that cross, or would cross a little further on, stay within tolerance all the
// same.
//
// A pair of cells that is certified holds nothing but arcs. Beside an arc the surfaces leave each
// other, at an angle theta they are within tolerance for tolerance / theta. Where this is longer
// than two surfaces stay together that touch, about the root of tolerance and size, the arc alone
// does not tell that they do; nor does a pair without arcs, whose cells end before they cross.

#pragma once

#include <array>
#include <vector>

#include "core/cells/cell_tree.h"
#include "core/surfaces/pairs/pair_search_result.h"

namespace blossom {

/// True if the middles of two cells cross at so small an angle.
///
/// tolerance, size   model units; the size is that of the surfaces
bool cross_slowly(const Cell& a, const Cell& b, double tolerance, double size);

/// True if two cells lie over each other in a slab no thicker than the tolerance: all over the
/// smaller one they are within tolerance.
bool lie_over(const Cell& a, const Cell& b, int points_a, int points_b, double tolerance);

/// The same for cells that do not meet, of which halving would tell no more.
bool are_within(const Cell& a, const Cell& b, int points_a, int points_b, double tolerance);

/// Adds the part of a pair of such cells in which they are over each other and within tolerance, to
/// a sixteenth of a cell, if it is not empty.
///
/// patches     of a and b
/// tolerance   model units
void add_near_part(const std::array<int, 2>& patches, const CellTree& tree_a, const Cell& a,
                   const CellTree& tree_b, const Cell& b, double tolerance,
                   std::vector<CriticalPair>& parts);

}  // namespace blossom
