// SPDX-License-Identifier: LGPL-2.1-or-later
// Common points of edges and faces of Open CASCADE, by the core's certified engines.
//
// Parameters in the results are Open CASCADE's own. Lines, conics and B-splines are taken exactly;
// hyperbolas and offset curves within a tenth of the point tolerance, and then the status is
// `tolerance` at best.

#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include "core/curve_intersection.h"
#include "core/curve_surface_intersection.h"

namespace blossom::occt {

/// Why a result is within tolerance in which points are on a wire of the face.
inline constexpr const char* kPointsOnWires = "points on a wire of the face";

/// All common points of two edges. Seams and ends of closed edges count as points of the curves.
/// throws   BadModel as `bezier_spans` (convert/curves.h)
CurveIntersection intersect(const TopoDS_Edge& a, const TopoDS_Edge& b,
                            const IntersectionOptions& options = {});

/// The points in which the curve of an edge meets itself.
/// throws   BadModel as above
CurveIntersection self_intersections(const TopoDS_Edge& edge,
                                     const IntersectionOptions& options = {});

/// All common points of an edge and a face. Points outside of the face's trims are left out; those
/// within tolerance of a wire are kept, their places listed, as which side they lie on is not
/// proven. Runs in the surface are listed as far as the parameter box of the face goes, not clipped
/// to its trims.
/// throws   BadModel as above, or if the face cannot be converted
CurveSurfaceIntersection intersect(const TopoDS_Edge& edge, const TopoDS_Face& face,
                                   const IntersectionOptions& options = {});

}  // namespace blossom::occt
