// SPDX-License-Identifier: LGPL-2.1-or-later
// The search for contacts: cells of one surface against charts of the other, by their gap.
//
// Pairs of cells that are nearly parallel come here from the search over pairs. A cell of a ends
// as empty, regular, read by its valley, in contact all over, or, at a limit, open; else it is
// halved.

#pragma once

#include <vector>

#include "core/base/work_limit.h"
#include "core/cells/known_curves.h"
#include "core/cells/surface_cells.h"
#include "core/surfaces/pairs/pair_search_result.h"
#include "core/surfaces/pairs/quadric_band.h"

namespace blossom {

/// The cells of one patch of a that have to be searched against a part of a patch of b.
struct ContactTask {
  int patch_a = 0;
  int patch_b = 0;
  std::vector<int> cells_a;                      ///< disjoint cells of a's tree
  std::vector<std::array<Interval, 2>> parts_b;  ///< where b may come close to them
  const QuadricBand* band_b = nullptr;           ///< of the patch of b; null if it has none
};

/// Searches one pair of patches; adds what it finds to `result`.
///
/// size      of the surfaces, model units
void search_contacts(SurfaceCells& a, SurfaceCells& b, const ContactTask& task, double size,
                     const KnownCurves& known, const IntersectionOptions& options,
                     const WorkLimit& limit, PairSearchResult& result);

}  // namespace blossom
