// SPDX-License-Identifier: LGPL-2.1-or-later
// Ends of intersection curves at wires that they cross at a small angle.

#pragma once

#include <vector>

#include "core/math/interval.h"
#include "core/results/result.h"
#include "core/topology/face_trims.h"

namespace blossom {

/// Moves ends of parts of a curve, at wires, to where the wire goes through the other surface.
///
/// A curve is as far off as it is fitted, and where it crosses a wire at an angle alpha its place
/// on the wire is 1 / sin alpha times that far off. Where this is more than kOnWire the place is
/// found anew from the wire and the other surface alone, by Newton's method: the curves of all
/// faces that meet in the edge then end in one place of it. An end stays where it is if the curve
/// keeps off that place, or if it lies on wires of both faces.
///
/// b       null if everything of the second surface counts; ends stay as they are then
/// reach   how far from a wire a curve may end there; model units
/// parts   of the curve's parameter, increasing and disjoint
void move_shallow_ends(const IntersectionCurve& curve, const FaceTrims& a, const FaceTrims* b,
                       double reach, std::vector<Interval>& parts);

}  // namespace blossom
