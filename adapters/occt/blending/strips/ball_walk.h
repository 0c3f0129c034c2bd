// SPDX-License-Identifier: LGPL-2.1-or-later
// The way of a ball along a run of edges: strips one after the other, each on two faces.
//
// The ball starts beside an edge and rolls on. Where a contact goes over an edge at which the faces
// go on smoothly, the ball goes on over the neighbour and the next strip begins, wherever the
// filleted edges have their vertices. So a strip need not belong to an edge.

#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <vector>

#include "adapters/occt/blending/body_edges.h"
#include "adapters/occt/blending/edge_chain.h"
#include "adapters/occt/blending/strips/face_contacts.h"
#include "adapters/occt/blending/strips/rolled_strip.h"
#include "adapters/occt/fillet.h"
#include "core/base/tolerances.h"

namespace blossom::occt {

/// A strip and how the ball walks along it.
struct WalkedStrip {
  RolledStrip strip;
  bool forward = true;  ///< as t grows
  double inside = 0;    ///< a t that the ball passes
  bool of_edge = true;  ///< whether it is on the faces of the edge that it is named after
};

/// Where one strip ends and the next begins.
struct WalkJoint {
  double before = 0, after = 0;  ///< t of both strips
  /// The edges that the contacts go over there, to the left and right of the way.
  std::array<std::optional<ContactCrossing>, 2> over;
};

/// An edge of a run beside which there is no ball of that radius, but beside those before and
/// behind it: the run is cut there.
struct PassedEdge {
  int edge = 0;
  FilletRefusal why;
};

struct BallWalk {
  EdgeRun run;
  std::vector<WalkedStrip> strips;
  /// Between each strip and the next; of a closed walk between the last and the first, too.
  std::vector<WalkJoint> joints;
  std::vector<PassedEdge> passed{};  ///< between this one and others of the run, or its own ends
};

/// What a walk has to know.
struct WalkOptions {
  FilletOptions fillet;                   ///< radii, section, chamfer
  double tolerance = Tolerances{}.point;  ///< model units
  std::set<int> filleted;                 ///< all edges that have fillets
  std::function<void()> tick = [] {};     ///< called for each strip; may throw to stop
  /// Edges in which runs would go on, but end before them.
  std::set<int> ended_before{};
};

/// One walk along all edges of the run. Where the ball would come to a sharp edge beside a vertex
/// of the run, as at faces that go on smoothly in the vertex alone, the run is cut: two walks end
/// there, and their strips run into each other. It is also cut at edges that are too tight for the
/// ball, as the rounding of a corner that has a smaller radius: these are passed.
/// throws   FilletRefused if there is no ball beside the edges, or it leaves them on the way
std::vector<BallWalk> ball_walks(const BodyEdges& body, const EdgeRun& run,
                                 const WalkOptions& options);

}  // namespace blossom::occt
