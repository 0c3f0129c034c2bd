// SPDX-License-Identifier: LGPL-2.1-or-later
// Which edges a fillet goes along, and of which kind they are.

#pragma once

#include <map>
#include <vector>

#include "adapters/occt/blending/body_edges.h"

namespace blossom::occt {

/// Edges to be filleted, by number, and whether they are concave.
using FilletEdges = std::map<int, bool>;

/// The edge with all edges in which it goes on smoothly: where at a vertex exactly one other sharp
/// edge of the same kind has its direction.
/// throws   FilletRefused if it, or one of those, cannot have a fillet
FilletEdges smooth_chain(const BodyEdges& body, int edge);

}  // namespace blossom::occt
