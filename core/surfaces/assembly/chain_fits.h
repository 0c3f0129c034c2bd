// SPDX-License-Identifier: LGPL-2.1-or-later
// Chains of arcs as curves, or not: what is no longer than a contact is none.

#pragma once

#include <optional>
#include <vector>

#include "core/base/work_limit.h"
#include "core/cells/surface_cells.h"
#include "core/forms/surface.h"
#include "core/results/result.h"
#include "core/surfaces/branches/arc_chains.h"
#include "core/surfaces/pairs/pair_search_result.h"

namespace blossom {

/// What all chains of one search have in common; nothing is kept. Lengths are in model units.
struct FitContext {
  const PairSearchResult& found;
  SurfaceCells& cells_a;
  SurfaceCells& cells_b;
  const BezierSurface& a;
  const BezierSurface& b;
  Vec3 origin;                ///< of the cells' coordinates
  double size = 1;            ///< diagonal of the larger surface
  double tolerance = 0;       ///< within which the images of a curve shall agree
  double contact_length = 0;  ///< along which a curve that only touches a border stays beside it
  double gap = 0;             ///< of the surfaces along their tangential curves
  const WorkLimit& limit;
};

struct ChainFits {
  /// One for each chain; none where the chain is no longer than a contact. The length of one that
  /// was not traced, or not in time, is not a number.
  std::vector<std::optional<IntersectionCurve>> curves;
  const char* stopped = nullptr;  ///< the limit that was reached before all were fitted
};

/// Fits the chains by all threads, some at a time; between these the limit is asked.
ChainFits fitted_chains(const FitContext& context, const std::vector<Chain>& chains);

/// Whether a chain ends in a listed contact: a branch as short as the tolerance is part of it then.
bool belongs_to_contact(const Chain& chain);

}  // namespace blossom
