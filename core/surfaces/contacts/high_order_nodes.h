// SPDX-License-Identifier: LGPL-2.1-or-later
// Nodes in which two surfaces agree up to the second order or a higher one: a line of contact
// crosses a branch there, or three branches or more meet.
//
// Round such a node the gap is less than the tolerance over a disc much wider than the tolerance,
// and less than it along valleys that are no contact (`core/surfaces/gap/node_form.h`). What the
// search has found in the disc says nothing about where the lines run, so it is taken together,
// and branches end on its border.

#pragma once

#include <vector>

#include "core/surfaces/contacts/contact_chain.h"

namespace blossom {

/// Makes one point of all contacts, clusters and arcs in the disc of each such node within both
/// surfaces. Branches are cut where they come into it and are its arms; tangential curves that come
/// out of it begin in the node.
///
/// size, tolerance   model units
void gather_at_high_order_nodes(std::vector<ContactChain>& chains,
                                std::vector<CriticalCluster>& clusters, PairSearchResult& found,
                                SurfaceCells& a, SurfaceCells& b, double size, double tolerance);

}  // namespace blossom
