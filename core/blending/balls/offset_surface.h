// SPDX-License-Identifier: LGPL-2.1-or-later
// A surface at a distance from another one, as patches.
//
//   O = S + d n,   n = S_u x S_v / |S_u x S_v|
//
// has the parameters of S, and is as smooth as n wherever that exists, also where it folds. It is
// not rational, so it is fitted patch by patch at Chebyshev's extreme points.

#pragma once

#include "core/blending/balls/ball_track.h"
#include "core/forms/surface.h"

namespace blossom {

struct OffsetSurface {
  /// The fit over the part; knots are those of S in the part and more. Its `error` is set.
  BezierSurface surface;

  /// Largest distance of the fit from O at equal parameters, model units, and largest difference
  /// of the derivatives by the patches' local parameters: measured at the extreme points of twice
  /// the degree and doubled. The error of such an interpolant is a function with about the same
  /// points of largest size, half of which these points have; no proof.
  double error = 0;
  double slope_error = 0;
};

/// The offset of a part of a surface.
///
/// distance    signed, model units
/// tolerance   of the fit, model units
/// returns     neighbouring patches share their borders; u and v are refined apart
/// throws      InvalidInput if the surface is not well formed, the part is empty or leaves it, the
///             normal vanishes in the part other than on a border that is a point, it jumps across
///             a knot line, or the fit does not become good enough
OffsetSurface offset_surface(const BezierSurface& surface, const ChartRectangle& part,
                             double distance, double tolerance);

}  // namespace blossom
