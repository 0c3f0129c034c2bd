// SPDX-License-Identifier: LGPL-2.1-or-later
// The borders of faces while a blend sheet is put into a body, before they are put together to
// wires.
//
// A contact may run along an edge of its face, or along another contact: a ball as large as a wall
// is thick, two as large as half of it. What of the face is between them has no width, and no wire
// can go round it: such edges go out of the face in pairs, and in the faces beside it become one.

#pragma once

#include <vector>

#include <TopAbs_Orientation.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include "adapters/occt/blending/body_edges.h"
#include "core/math/vec.h"

namespace blossom::occt {

/// The edges of a face on its way to a new one, in any order.
struct FaceBorder {
  TopoDS_Face of;                  ///< forward
  std::vector<TopoDS_Edge> edges;  ///< as the forward face uses them
  Vec2 scale{1, 1};                ///< of its parameters, to lengths
  int from = 0;                    ///< number of the body's face; 0: of the sheet
  int edge = 0;                    ///< of the sheet: the filleted edge
  TopAbs_Orientation orientation = TopAbs_FORWARD;
};

/// What another edge, or pieces of it, took the place of.
struct ReplacedEdge {
  TopoDS_Edge lost;              ///< forward
  std::vector<TopoDS_Edge> now;  ///< forward
};

/// Takes edges that run along each other, with nothing between, out of borders in pairs; where they
/// do so only in part they are split at the ends of it before.
///
/// tolerance   edges are along each other within it, or their own; model units
/// returns     what became of edges, in the order in which it did
std::vector<ReplacedEdge> close_slivers(std::vector<FaceBorder>& borders, const BodyEdges& body,
                                        double tolerance);

}  // namespace blossom::occt
