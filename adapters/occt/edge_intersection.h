// SPDX-License-Identifier: LGPL-2.1-or-later
// All points and stretches that edges have in common with a shape.

#pragma once

#include <string>
#include <vector>

#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>

#include "core/base/status.h"
#include "core/math/interval.h"
#include "core/math/vec.h"
#include "core/results/options.h"

namespace blossom::occt {

/// A point in which an edge meets the shape, and no stretch begins or ends.
struct EdgePoint {
  int edge = 0;          ///< place in the list of edges
  double parameter = 0;  ///< of the edge
  Vec3 point;
  TopoDS_Shape on;  ///< the vertex, edge or face that it is on: of several that of least dimension
};

/// A stretch that lies on the shape.
struct EdgeStretch {
  int edge = 0;
  Interval range;     ///< parameters of the edge
  TopoDS_Shape on;    ///< an edge, or a face
  double length = 0;  ///< model units
};

/// What edges and a shape have in common.
struct EdgeIntersection {
  Status status = Status::Complete;
  std::vector<EdgePoint> points;  ///< each place once, also where several edges end in it
  std::vector<EdgeStretch> stretches;
  std::vector<std::string> reasons;  ///< why the status is not complete
};

/// Each edge with all faces, edges and vertices of the shape, its inside left out of account.
///
///   (1) what is nearer than the tolerance, or than what the two state, is a common point
///   (2) stretches begin and end where edge and shape part, or where the edge comes to the next
///       face
///   (3) contacts by `one_within` (core/base/tolerances.h) are decided, others make the status
///       Tolerance; runs only of lines and circles with each other and in elementary surfaces, or
///       proven by coefficients
///   (4) once a limit is reached the status is Stopped; what was found of other edges is kept
///
/// throws   BadModel if an edge has no curve in space, or if it comes near a face that cannot be
///          converted
EdgeIntersection intersect_edges(const std::vector<TopoDS_Edge>& edges, const TopoDS_Shape& shape,
                                 const IntersectionOptions& options = {});

/// The stretches as wires, joined where they meet, and a vertex for each point, as `joined_curves`
/// has them.
/// edges     those that were intersected
/// throws    Failure if Open CASCADE refuses one
TopoDS_Compound joined_edges(const std::vector<TopoDS_Edge>& edges, const EdgeIntersection& met);

}  // namespace blossom::occt
