// SPDX-License-Identifier: LGPL-2.1-or-later
// Edges with what is near them: which curves may run along them, and in which faces they may lie.

#pragma once

#include <functional>
#include <vector>

#include <Geom_Surface.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include "core/bounds/box_tree.h"
#include "core/results/result.h"

namespace blossom::occt {

/// The edges that bound a face, forward and once each; those without length are left out.
std::vector<TopoDS_Edge> bounding_edges(const TopoDS_Face& face);

/// How near to an edge counts as on it; model units.
using EdgeReach = std::function<double(const TopoDS_Edge&)>;

/// An edge with a box of all that is within reach of it.
struct EdgeInReach {
  TopoDS_Edge edge;
  Box box;
  double reach = 0;
};

std::vector<EdgeInReach> edges_in_reach(const std::vector<TopoDS_Edge>& edges,
                                        const EdgeReach& reach_of);

/// The box of the control points; it holds the curve.
Box spline_box(const Spline& curve);

/// Two faces that cross, each of which may be off by the tolerance.
struct CrossedFaces {
  Handle(Geom_Surface) a, b;
  double tolerance = 0;

  /// How far the curve may be from its place at a point: by the tolerances over the sine of the
  /// angle between the faces there, which may be as small as 0 at an end alone.
  double reach_at(const SurfacePoint& of) const;
};

/// Whether a curve is near one of the edges all along: at its samples, of which a straight one has
/// hardly more than its ends, and at points between them.
bool follows(const IntersectionCurve& curve, const std::vector<EdgeInReach>& edges,
             const CrossedFaces& crossed);

/// Whether it may be, by a few points between its ends.
bool may_follow(const IntersectionCurve& curve, const std::vector<EdgeInReach>& edges);

/// Whether an edge in which the surface of its face ends may lie on another one. The two surfaces
/// may miss each other there by rounding, and leave no curve. On other surfaces than planes only
/// seams are tried, since it takes time and most edges lie on none.
///
/// edges       of the face `of`
/// tolerance   of the search on `other`, model units
bool may_lie_on(const std::vector<TopoDS_Edge>& edges, const TopoDS_Face& of,
                const TopoDS_Face& other, double tolerance, const EdgeReach& reach);

}  // namespace blossom::occt
