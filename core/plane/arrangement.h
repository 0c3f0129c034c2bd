// SPDX-License-Identifier: LGPL-2.1-or-later
// The arrangement of a face's loops and of cuts in its chart, as a walk over half-edges.
//
// The walk is combinatorial. Arcs meet where they name the same vertex, never because their ends
// are near; only the order of the arms round a vertex is read from the curves: by direction,
// then by curvature.

#pragma once

#include <span>
#include <vector>

#include "core/plane/loops.h"

namespace blossom {

struct ChartArc {
  int from = 0;  ///< vertices, any numbers from 0 on; equal for a closed arc
  int to = 0;
  PlanarPath path;      ///< directed from `from` to `to`, not empty
  bool border = false;  ///< a piece of a trimming loop, with the face on its left
};

struct HalfEdge {
  int arc = 0;            ///< index of the arc
  bool reversed = false;  ///< walked from `to` to `from`

  friend bool operator==(const HalfEdge&, const HalfEdge&) = default;
};

/// Half-edges, each of which starts at the vertex where the one before ends; the enclosed region
/// lies on the left.
using Cycle = std::vector<HalfEdge>;

struct Cycles {
  std::vector<Cycle> cycles;  ///< all, those outside the face too
  std::vector<int> dangling;  ///< arcs that divide nothing; in no cycle
};

/// All cycles of the arrangement. An arc with the same cycle on both sides divides nothing: it is
/// left out and listed.
///
/// arcs      they meet only at vertices
/// tolerance   arcs that touch in a vertex may cross beside it, and be so far apart in between:
///             they are ordered by what they do beyond. Chart units
/// throws    InvalidInput if a vertex is negative or a path is empty
///
/// Source: the walk of a doubly connected edge list, de Berg et al. 2008, section 2.2.
Cycles cycles(std::span<const ChartArc> arcs, double tolerance = 0);

/// The area on the left of a cycle, negative when the cycle goes round clockwise. Chart units.
double signed_area(std::span<const ChartArc> arcs, const Cycle& cycle);

/// Whether the cycle goes round the point.
bool encloses(std::span<const ChartArc> arcs, const Cycle& cycle, const Vec2& point);

}  // namespace blossom
