// SPDX-License-Identifier: LGPL-2.1-or-later
// Pieces of curves that are part of a contact.

#pragma once

#include <vector>

#include "core/cells/surface_cells.h"
#include "core/surfaces/branches/arc_chains.h"
#include "core/surfaces/contacts/contact_chain.h"
#include "core/surfaces/contacts/critical_places.h"
#include "core/surfaces/pairs/pair_search_result.h"

namespace blossom {

/// What is shorter is no branch but a part of the contacts at its ends. Tolerances.
inline constexpr double kShortestBranch = 4;

/// Drops the arcs of chains that are as short as the contact they begin in, and takes them from its
/// arms: chains from a point of contact back to it, which happened to be certified, and at a pole
/// those to or along a border that it reaches.
///
/// tolerance    model units
void drop_spurious_branches(PairSearchResult& found, SurfaceCells& a, SurfaceCells& b,
                            std::vector<ContactChain>& contacts,
                            const std::vector<CriticalCluster>& clusters, double tolerance);

}  // namespace blossom
