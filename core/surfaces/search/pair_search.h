// SPDX-License-Identifier: LGPL-2.1-or-later
// The search over pairs of cells: exclude, certify, or halve.
//
// Every pair of cells ends as one of three: proven empty, certified with its arcs, or critical.
// Nothing else happens to a pair, so together they account for all of both surfaces.

#pragma once

#include <vector>

#include "core/cells/known_curves.h"
#include "core/cells/surface_cells.h"
#include "core/forms/surface.h"
#include "core/results/options.h"
#include "core/surfaces/pairs/pair_search_result.h"

namespace blossom {

/// Examines pairs of cells of two surfaces, or of one that do not touch in its parameters.
/// pairs     all that may meet
/// size      of the surfaces, model units
PairSearchResult search_pairs(SurfaceCells& a, SurfaceCells& b, const std::vector<StartPair>& pairs,
                              double size, const KnownCurves& known,
                              const IntersectionOptions& options);

}  // namespace blossom
