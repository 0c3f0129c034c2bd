// SPDX-License-Identifier: LGPL-2.1-or-later
// Points in which two surfaces agree up to the second order: a line of contact crosses a branch
// there, or three branches meet.
//
// Round such a node the gap is a cubic form of the place, which is less than the tolerance over a
// disc much wider than the tolerance, and less than it along valleys that are no contact. What the
// search has found in the disc says nothing about where the lines run, so it is taken together.

#pragma once

#include <vector>

#include "core/surfaces/contacts/contact_chain.h"

namespace blossom {

/// Makes one point of all contacts, clusters and arcs in the disc of each third-order node within
/// both surfaces, and lets the tangential curves that come out of it begin there.
///
/// size, tolerance   model units
void gather_at_third_order_nodes(std::vector<ContactChain>& chains,
                                 std::vector<CriticalCluster>& clusters, PairSearchResult& found,
                                 SurfaceCells& a, SurfaceCells& b, double size, double tolerance);

}  // namespace blossom
