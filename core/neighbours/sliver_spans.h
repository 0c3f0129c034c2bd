// SPDX-License-Identifier: LGPL-2.1-or-later
// Slivers: border spans of a face's surface that are narrower than the edge along them is exact.
//
// Surfaces that were approximated span by span may begin or end with a span as narrow as rounding
// in its parameter, whose control points go to and fro by more than its width: its derivatives have
// every direction, and it folds over itself many times, all within the tolerance of the edge along
// it. By that tolerance it is the edge. What is left is a surface that can be decided.

#pragma once

#include <optional>

#include "core/results/options.h"
#include "core/results/result.h"
#include "core/topology/face_data.h"

namespace blossom {

/// A surface without its slivers.
struct WithoutSlivers {
  BezierSurface surface;
  double within = 0;  ///< a bound on what was left out, or moved to close a seam, model units
};

/// The face's surface without the border spans that lie within the tolerance of the edges along
/// them; nothing if there are none. Where a seam runs through them, what is left is closed again by
/// moving its border to the other side of the seam, no farther than that tolerance.
std::optional<WithoutSlivers> without_sliver_spans(const FaceData& face);

/// A bound on the distance of any two points of a patch that are on one parameter line across,
/// model units.
///
/// across    0: lines along which u grows, 1: v
double width_across(const RationalBezierPatch& patch, int across);

/// Where the face's surface meets itself, slivers aside, not clipped to the trims. The
/// certificate counts slivers as identified with their edges; what is found, if anything, is as
/// exact as they are, and so within tolerance only.
SurfaceIntersection with_itself(const FaceData& face, const IntersectionOptions& options);

}  // namespace blossom
