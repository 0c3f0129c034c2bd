// SPDX-License-Identifier: LGPL-2.1-or-later
// Two faces on one surface: what they have in common, told by their outlines.

#pragma once

#include <vector>

#include <TopoDS_Face.hxx>

#include "adapters/occt/faces/pairs/shared_edges.h"
#include "core/base/work_limit.h"
#include "core/results/result.h"

namespace blossom::occt {

/// The intersection of two faces on one surface.
///
/// Their edges are intersected in space, which tells whether they cross, run along each other or
/// end on each other. Common regions are overlaps; edges along which the faces lie side by side are
/// tangential curves; corners and other points in which nothing else meets are points. The status
/// is Complete if the surfaces and every contact of two edges, but for proven crossings, are within
/// `within`; these contacts are identified. It is Tolerance if some are farther apart.
///
/// edges       that both faces have: what lies along them is left out, and no contact
/// gap         bound on the distance of the two surfaces, model units, within the tolerance
/// within      what is as near as this is one (core/base/tolerances.h)
/// tolerance   model units
/// throws      Failure or BadModel if the outlines cannot be laid over each other
SurfaceIntersection on_one_surface(const TopoDS_Face& a, const TopoDS_Face& b,
                                   const std::vector<SharedEdge>& edges, double gap, double within,
                                   double tolerance, const WorkLimit& limit);

}  // namespace blossom::occt
