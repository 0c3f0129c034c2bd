// SPDX-License-Identifier: LGPL-2.1-or-later
// Whether a piece turns over when its control points are moved.

#pragma once

#include "core/forms/patch.h"
#include "core/forms/triangle.h"

namespace blossom {

/// Whether the normals of two triangles at equal parameters are proven to be less than a right
/// angle apart: then the moved one folds over nowhere where the given one does not.
///
///   N . N' = sum c_k B_k of degree 2 (n + n' - 2),   N = T_x x T_y
///
/// Where a c_k is negative beyond rounding the triangles are halved. A part of the moved one also
/// counts as proven where all of its normals are on the side of the mean of those given, so that it
/// is a graph over a plane.
///
/// given, moved   of degrees from 1 to kMaxDegree; the given points count as known to rounding of
///                the largest coordinate, so that a side at a pole may be a point
/// within         parts of both that are narrower count as proven, as beside a corner where two
///                sides leave in one direction; model units
/// returns        false also if divisions do not tell
/// throws         InvalidInput if a degree is not in that range or does not fit the points
/// cost           O(n^4)
bool turns_nowhere(const BezierTriangle& given, const BezierTriangle& moved, double within);

/// The same of the triangles on both sides of the diagonal of a patch.
///
/// returns  false also for degrees whose sum is above kMaxDegree
bool turns_nowhere(const BezierPatch& given, const BezierPatch& moved, double within);

}  // namespace blossom
