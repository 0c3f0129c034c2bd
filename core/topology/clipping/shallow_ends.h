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
/// found anew from the wire and the other surface alone, by Newton's method. Curves of several
/// faces that meet in an edge then end in one place of it, as far as the chart curves of the edge
/// are one.
///
/// An end stays where it is if the wire runs along the other surface, if both faces have a wire
/// there, or if the place found is farther off than the angle accounts for, off the curve, or in
/// another part.
///
/// b       null if everything of the second surface counts; ends stay as they are then
/// reach   how far from a wire a curve may end there; model units
/// parts   of the curve's parameter, disjoint; those without length stay
void move_shallow_ends(const IntersectionCurve& curve, const FaceTrims& a, const FaceTrims* b,
                       double reach, std::vector<Interval>& parts);

}  // namespace blossom
