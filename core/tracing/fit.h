// SPDX-License-Identifier: LGPL-2.1-or-later
// B-splines along a traced chain: in space and in both charts, on common knots.
//
// The three curves are one quintic spline in seven coordinates. Between two points of the chain
// it takes over position, tangent and curvature of all of them (Hermite), with arc length as
// parameter, so it is curvature continuous wherever the intersection is. Segments are halved
// until the three images agree.

#pragma once

#include "core/forms/surface.h"
#include "core/intersection/result.h"
#include "core/tracing/trace.h"

namespace blossom {

struct FitOptions {
  double tolerance = 1e-7;  ///< wanted agreement of the three images, model units
  double size = 1;  ///< diagonal of the larger surface: samples get chords within 1e-4 of it
};

/// The curve of a chain: splines, samples, length, least angle and measured deviation. `ends`,
/// `closed` and `tangential` are left to the caller.
IntersectionCurve fitted(const ChainTracer& tracer, const BezierSurface& a, const BezierSurface& b,
                         const FitOptions& options);

}  // namespace blossom
