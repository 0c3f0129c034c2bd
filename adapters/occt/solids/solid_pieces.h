// SPDX-License-Identifier: LGPL-2.1-or-later
// Two solids split along their intersection, so that both sides of each curve have the same edge.

#pragma once

#include <string>
#include <vector>

#include "adapters/occt/intersection.h"
#include "adapters/occt/solids/solid_sides.h"
#include "adapters/occt/splitting/common_edges.h"
#include "core/surface_intersection.h"

namespace blossom::occt {

/// The pieces of both solids, or why there are none.
struct SolidPieces {
  Status status = Status::Complete;  ///< of the intersection
  Certificate certificate;
  std::vector<SolidPiece> a;
  std::vector<SolidPiece> b;
  std::vector<std::string> obstacles;  ///< none if the pieces can be used
  std::vector<std::string> merged;     ///< pieces of both, or cuts, that are apart and count as one
  double between = 0;                  ///< about the volume between such pieces, cubic model units
};

/// How much is told of what stands against a division.
enum class Causes { Short, WhereCutsBreakOff };

/// Splits the faces of two solids along each other.
///
/// Every intersection curve becomes edges that pieces of both solids share, with curves in the
/// parameters of both. Edges of one that lie in faces of the other divide these; edges that run
/// along each other become one, so that faces that coincide have pieces that do as a whole. The
/// sides of pieces are decided at the cuts and checked by rays, or decided by rays that agree where
/// the cuts do not tell.
///
/// Surfaces that touch in a point divide nothing, and along a curve what it goes across; where they
/// may cross there as well, or the intersection stayed open, there is an obstacle. A cusp is none
/// while the pieces round it fit together. An edge that one side has already along a curve, as a
/// seam that it touches, takes the place of the other side's.
///
/// found     between the faces of both
/// options   the tolerance of `found`; limits of the work
/// causes    where cuts break off is looked for if there are obstacles, unless a limit is reached
/// throws    BadModel if a face cannot be converted
SolidPieces solid_pieces(const TrimTool& a, const TrimTool& b, const ShapeIntersection& found,
                         EdgesLie lying, const IntersectionOptions& options, Causes causes);

}  // namespace blossom::occt
