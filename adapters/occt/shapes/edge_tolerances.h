// SPDX-License-Identifier: LGPL-2.1-or-later
// Edges that state other tolerances than their curves need.

#pragma once

#include <string>

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>

#include "adapters/occt/splitting/trim_sides.h"
#include "core/intersection/work_limit.h"

namespace blossom::occt {

/// The tolerance that the curves of an edge ask for on the faces that it bounds, model units; at
/// least Open CASCADE's confusion. The one it has where it lacks a curve, and no less than that at
/// a degenerated edge, which asks for the distances of its images from its vertex.
double needed_tolerance(const TopoDS_Edge& edge, const TopTools_ListOfShape& faces);

/// How far the curves of an edge on these faces end from a vertex of it, as oriented in the edge.
double distance_at(const TopoDS_Vertex& vertex, const TopoDS_Edge& edge,
                   const TopTools_ListOfShape& faces);

/// Tolerances that were raised.
struct RaisedTolerances {
  TopTools_IndexedMapOfShape edges, vertices;

  /// Of those that they have now, model units.
  double largest() const;
};

/// Raises those tolerances of the shape itself that are less than the distances of its curves:
/// readers of files without tolerances measure these at a few points of each edge.
RaisedTolerances raise_tolerances(const TopoDS_Shape& shape);

/// A solid whose tolerances are true, and what was not so; empty if everything was.
struct TrueSolid {
  TrimTool solid;
  std::string told;
};

/// Raises the tolerances of edges and vertices that are less than the distances of their curves,
/// and lowers those that are more than ten times these: intersections that end on an edge are
/// looked for as far as its tolerance says.
///
/// The given shapes keep theirs: where something is not true, all faces and solids are copies that
/// share the geometry, in the same order.
///
/// solid    a closed one
/// limit    asked before each edge
/// throws   Failure when the limit is reached, or Open CASCADE fails
TrueSolid with_true_tolerances(const TrimTool& solid, const WorkLimit& limit);

}  // namespace blossom::occt
