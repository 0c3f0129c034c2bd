// SPDX-License-Identifier: LGPL-2.1-or-later
// The pairs of cells that a search over pairs begins with. Most are of patches whose boxes meet but
// which are apart; these need nothing that is kept for pairs of patches.

#pragma once

#include <vector>

#include "core/cells/surface_cells.h"
#include "core/results/result.h"

namespace blossom {

struct NearPairs {
  std::vector<StartPair> pairs;  ///< in the order given
  Certificate certificate;       ///< of those left out
};

/// True if the parts of two cells that count are farther apart than `gap`, model units, by their
/// boxes or fat planes.
bool are_apart(const CellTree& tree_a, const Cell& a, const CellTree& tree_b, const Cell& b,
               double gap);

/// Makes the trees of all patches named, and leaves out the pairs that are apart; by all threads.
NearPairs near_pairs(SurfaceCells& a, SurfaceCells& b, const std::vector<StartPair>& pairs,
                     double gap);

}  // namespace blossom
