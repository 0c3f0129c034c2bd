// SPDX-License-Identifier: LGPL-2.1-or-later
// What lies between the border of a face and the edges that it shares with its neighbours.

#pragma once

#include <functional>

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include "core/math/interval.h"
#include "core/math/vec.h"

namespace blossom::occt {

/// Integrates over the strips of straight lines from the border of a face, the images of its
/// pcurves, to the curves of its edges. With them the faces of a closed shell end in the same
/// curves: what they enclose does not depend on the point that its cones start from, but for what
/// is open at corners, a tolerance squared for each. Edges of Open CASCADE's confusion (1e-7) or
/// less are left out, and those without a curve in space.
///
/// add        called at each node of the rule with the point there, and with the strip's normal,
///            as that of the forward face, times its share of the strip's area, square model units
/// accuracy   Gauss's rule of 5 nodes along each smooth piece of an edge, and of 3 across
/// throws     BadModel if an edge has no pcurve
void over_border_strips(const TopoDS_Face& face,
                        const std::function<void(const Vec3& point, const Vec3& normal)>& add);

/// The same along a part of one edge, of any tolerance.
///
/// edge   as the forward face uses it
void over_border_strip(const TopoDS_Edge& edge, const TopoDS_Face& face, const Interval& part,
                       const std::function<void(const Vec3& point, const Vec3& normal)>& add);

}  // namespace blossom::occt
