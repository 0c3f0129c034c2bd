// SPDX-License-Identifier: LGPL-2.1-or-later
// In which order edges get their fillets where convex and concave ones meet.

#pragma once

#include <vector>

#include "adapters/occt/blending/edge_chain.h"

namespace blossom::occt {

/// Edges whose fillets are made at once, group after group, each in what the ones before made.
///
/// Where of three edges at a vertex one of its kind meets the others, it comes first: its strip
/// ends in a face that the others have in common, and they go on smoothly along that end. Edges of
/// one kind that meet are of one group, as their corners need all of them. Where these rules
/// contradict each other all edges are one group.
std::vector<FilletEdges> fillet_order(const BodyEdges& body, const FilletEdges& edges);

}  // namespace blossom::occt
