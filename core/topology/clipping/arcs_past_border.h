// SPDX-License-Identifier: LGPL-2.1-or-later
// Arcs by which an intersection curve goes past a border that it only touches.

#pragma once

#include <vector>

#include "core/results/result.h"
#include "core/topology/face_trims.h"

namespace blossom {

/// Whether a curve keeps to wires and is no longer than what touches one may be: it is on the
/// border, as far as can be told.
/// chart       in the surface's own parameters
/// tolerance   that counts as on a wire, model units
bool keeps_to_border(const FaceTrims& trims, const Spline2& chart, double tolerance);

/// A curve that touches a seam may cross it twice by what rounding moves it. Then it comes in
/// three: two curves that end in the seam, apart by as much as touches are long, and between them
/// an arc that keeps to the other side of the seam. The arc belongs to the curve before it or after
/// it, whose image goes on past the border by less than counts; so both meet again.
///
/// That curve goes on to the other one, or to the arc's other end, as a cubic piece with the
/// directions of both there, and its deviations are raised to the piece's, by samples.
///
/// arc      on the border of a or b, as `keeps_to_border` says
/// b        null if everything of the second surface counts
/// curves   one of them that ends where the arc does goes on; none that is a line or a conic
/// returns  false if none does, within the tolerance that it has as an edge
bool append_border_arc(const IntersectionCurve& arc, const FaceTrims& a, const FaceTrims* b,
                       std::vector<IntersectionCurve>& curves, double tolerance);

}  // namespace blossom
