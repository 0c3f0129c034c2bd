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

/// Replaces the border points of the pieces by the points of their common sides. A side inside of
/// a face takes the points of its first piece, with its ends at the vertices. A piece of higher
/// degree gets them elevated, one of lower degree keeps its own but for the ends. Sets `along` and
/// adds to `moved`.
///
/// pieces        with equal degrees along edges (equal_degrees.h)
/// uneven_edges  edges with a border that runs at another speed. Their distance along the edge is
///               a matter of parameters and vanishes when the edge is divided. Empty: none
SideMoves move_sides(WatertightPieces& pieces, const std::vector<bool>& uneven_edges = {});

}  // namespace blossom
