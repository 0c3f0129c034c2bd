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

/// The chain with all edges in which it goes on with a slight bend, of at most 0.1 radians.
/// throws   FilletRefused as `smooth_chain`
FilletEdges bent_chain(const BodyEdges& body, const FilletEdges& chain);

/// An edge on the way along a run.
struct RunEdge {
  int edge = 0;
  bool forward = true;
};

/// Edges that go on in one another smoothly, in order.
struct EdgeRun {
  std::vector<RunEdge> edges;
  bool closed = false;
  bool concave = false;

  DirectedEdge first() const { return {edges.front().edge, edges.front().forward}; }
  DirectedEdge last() const { return {edges.back().edge, !edges.back().forward}; }
};

/// The runs that filleted edges make up: they go on over vertices with two of them that have one
/// direction, and end at all others.
std::vector<EdgeRun> edge_runs(const BodyEdges& body, const FilletEdges& edges);

}  // namespace blossom::occt
