// SPDX-License-Identifier: LGPL-2.1-or-later
// Which of the edges that are rounded together have to do with each other at a place.

#pragma once

#include <set>
#include <vector>

#include "adapters/occt/blending/edge_chain.h"

namespace blossom::occt {

struct NearbyChains {
  std::vector<FilletEdges> chains;
  std::set<int> whole;  ///< edges of these at whose ends all is as with all chains
};

/// Of the chains, those with an edge that balls of a radius come to which roll along an edge: whose
/// box is not farther from its own than both balls' contacts may be from their edges, two radii
/// each; these are whole. And those that meet one of these in a vertex.
NearbyChains nearby_chains(const BodyEdges& body, const std::vector<FilletEdges>& chains, int edge,
                           double radius);

}  // namespace blossom::occt
