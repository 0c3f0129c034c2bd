// SPDX-License-Identifier: LGPL-2.1-or-later
// The edges that an intersection curve becomes in the faces of two solids, and how they fit.

#pragma once

#include <vector>

#include <TopoDS_Edge.hxx>

#include "adapters/occt/splitting/common_edges.h"
#include "adapters/occt/splitting/edges/edge_union.h"
#include "adapters/occt/splitting/face_splitter.h"
#include "core/forms/spline.h"
#include "core/math/interval.h"

namespace blossom::occt {

struct CurveEdge {
  Interval at;  ///< parameters of the curve, increasing
  TopoDS_Edge edge;
};

/// What a curve becomes on one side.
struct CurveEdges {
  std::vector<CurveEdge> made;
  std::vector<CurveEdge> along;  ///< that were there already; reversed where they run against it

  /// Adds the edge of a use, unless it is known.
  void add(const CutUse& use);
};

/// Whether each edge that one side made has its counterpart on the other: one that is made as well,
/// or one that was there, as where a curve touches a seam and runs along it within the tolerance.
bool is_matched(const CurveEdges& side, const CurveEdges& other);

/// Whether that is so of both.
bool match(const CurveEdges& a, const CurveEdges& b);

/// Joins an edge to what stands for another one, along which it runs in the direction that this
/// other one is turned to.
/// returns   false if the edge is joined to another one already
/// throws    Failure if they do not run along each other within their tolerances
bool join_along(const TopoDS_Edge& other, const TopoDS_Edge& edge, const CommonEdges& common,
                EdgeUnion& joined);

/// Joins the edges of two sides that match; those that were there stay.
/// returns   false if an edge is joined to another one already
/// throws    Failure if edges do not run along each other within their tolerances
bool join_matching(const CurveEdges& a, const CurveEdges& b, const CommonEdges& common,
                   EdgeUnion& joined);

/// The length of the longest piece of a curve that became no edge and runs along none, but for what
/// the tolerances of edges' vertices cover. Model units.
double longest_rest(const Spline& curve, const CurveEdges& a, const CurveEdges& b);

}  // namespace blossom::occt
