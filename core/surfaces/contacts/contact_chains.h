// SPDX-License-Identifier: LGPL-2.1-or-later
// Pieces of contact joined into whole contacts: points, nodes and tangential curves.

#pragma once

#include <vector>

#include "core/cells/surface_cells.h"
#include "core/surfaces/contacts/contact_chain.h"

namespace blossom {

/// Joins the pieces of contact, and makes contacts of the clusters that are points. Arcs of
/// tangential curves are added to `found.arcs`.
///
/// clusters            those that become contacts are taken out
/// size, tolerance   model units
std::vector<ContactChain> contact_chains(PairSearchResult& found, SurfaceCells& a, SurfaceCells& b,
                                         std::vector<CriticalCluster>& clusters, double size,
                                         double tolerance);

}  // namespace blossom
