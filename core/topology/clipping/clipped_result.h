// SPDX-License-Identifier: LGPL-2.1-or-later
// What the trims of two faces leave of an intersection of their surfaces.

#pragma once

#include <vector>

#include "core/results/result.h"
#include "core/topology/face_trims.h"

namespace blossom {

/// A contact of the trims, and how far what meets in it is apart there, model units.
struct Touch {
  SurfacePoint at;
  double gap = 0;
};

/// A curve on intervals of its parameter, in order; the last part of a loop and its first are one.
std::vector<IntersectionCurve> curve_parts(const IntersectionCurve& whole,
                                           const std::vector<Interval>& parts);

/// Leaves of an intersection what lies inside the trims of both. Common regions of the surfaces
/// stay among the places only, unless both faces are naturally bounded. Contacts that lie so far
/// outside that nothing inside is within tolerance are no reason for a weaker status.
/// b          null if everything of the second surface counts
/// tolerance  of touches: what goes past a wire by no more than this stays whole; model units
/// touching   likewise of arcs that keep to a border from end to end: what a curve that touches a
///            seam leaves on its other side goes to that curve; no less than kOnWire
/// returns    where curves only touch the trims, or have parts too short for an edge in them; but
///            for ends of curves and contacts of the result
std::vector<Touch> clip(SurfaceIntersection& found, const FaceTrims& a, const FaceTrims* b,
                        double tolerance = 0, double touching = kOnWire);

/// Adds touches to the contacts of a result. Those within `within` are identified; what is farther
/// apart is known within tolerance only, and so is the result.
void add_touches(const std::vector<Touch>& touches, double tolerance, double within,
                 SurfaceIntersection& found);

/// Whether what runs along trims lies inside of them is known within tolerance only, and so is the
/// result, unless it keeps within `within` of them, by samples: then it is identified with them.
void weaken_along_trims(const FaceTrims& a, const FaceTrims& b, double within,
                        SurfaceIntersection& found);

/// Sums of counts, the least of angles, all reasons.
void add(Certificate& sum, const Certificate& one);

}  // namespace blossom
