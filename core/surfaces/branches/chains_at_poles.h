// SPDX-License-Identifier: LGPL-2.1-or-later
// Ends of chains at poles, where parameters move but points do not.

#pragma once

#include <vector>

#include "core/cells/surface_cells.h"
#include "core/surfaces/branches/arc_chains.h"
#include "core/surfaces/contacts/contact_chain.h"
#include "core/surfaces/pairs/pair_search_result.h"

namespace blossom {

/// Near a pole a free parameter is rounding over the distance. One arc to the pole takes the place
/// of those at the end of a chain that are so near.
///
/// contacts          a chain that ends in a contact at a pole ends at the pole
/// size, tolerance   model units
void straighten_at_poles(std::vector<Chain>& chains, PairSearchResult& found, SurfaceCells& a,
                         SurfaceCells& b, const std::vector<ContactChain>& contacts, double size,
                         double tolerance);

}  // namespace blossom
