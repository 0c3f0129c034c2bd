// SPDX-License-Identifier: LGPL-2.1-or-later
// Watertight pieces with equal points along common sides.

#pragma once

#include <vector>

#include "core/watertight/watertight_pieces.h"

namespace blossom {

/// What it took to make sides equal.
struct SideMoves {
  std::vector<double> way;       ///< of each side: the largest of a control point; model units
  std::vector<double> edge_gap;  ///< of each side: its edge's distance from the surfaces
};

/// Puts the points of each side in the place of its pieces' own. Inner sides are those of their
/// first piece, with the ends at the vertices; a piece of another degree gets them elevated or, if
/// its own is lower, keeps its own but for the ends. Sets `along` and adds to `moved`.
///
/// pieces        with equal degrees along edges (equal_degrees.h)
/// uneven_edges  those with borders that run otherwise than they do. How far they are apart along
///               the edge is a matter of parameters, and passes when it is divided; without any:
///               none
SideMoves move_sides(WatertightPieces& pieces, const std::vector<bool>& uneven_edges = {});

}  // namespace blossom
