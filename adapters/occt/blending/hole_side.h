// SPDX-License-Identifier: LGPL-2.1-or-later
// What the neighbour of a hole's edge gives to the fill: exactly where the edge is an iso-parameter
// line inside one span of its surface, else by a polynomial fit with its error.

#pragma once

#include "adapters/occt/blending/hole_loop.h"
#include "core/blending/fills/fill_side.h"

namespace blossom::occt {

/// How near a fitted side has to be.
struct FitTolerance {
  double point = 1e-7;  ///< model units
  double angle = 1e-6;  ///< of the normals, radians
};

struct HoleSide {
  FillSide side;
  bool exact = false;
  double error = 0;        ///< of the border, model units; sampled, 0 if exact
  double angle_error = 0;  ///< of the normals, radians; likewise
};

/// The side of one edge, in the direction of the way round the hole, in model space.
/// throws   BadModel if the edge has no curve, no polynomial of degree up to kMaxFitDegree is near
///          enough, or a continuity other than G0 is asked for without a face
HoleSide hole_side(const HoleEdge& edge, FillContinuity continuity, const FitTolerance& tolerance);

/// The same by a fit in any case; the surface of the face may be without bounds.
HoleSide fitted_hole_side(const HoleEdge& edge, FillContinuity continuity,
                          const FitTolerance& tolerance);

/// Highest degree of fits: the fill's own degree is at most four higher at G2.
inline constexpr int kMaxFitDegree = 9;

}  // namespace blossom::occt
