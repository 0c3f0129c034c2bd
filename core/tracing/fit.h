// SPDX-License-Identifier: LGPL-2.1-or-later
// B-splines along a traced chain: in space and in both charts, on common knots.
//
// The three curves are one quintic spline in seven coordinates. Its parameter is arc length; where
// the curve is a line or a conic it is that one's, and the charts belong to its points. The
// knots are simple where the curve is smooth, chosen by the error that a first spline leaves, and
// triple to fivefold where a knot line of a surface lets a derivative jump. It is fitted by least
// squares to Hermite pieces between traced points (`core/tracing/spline_fit.h`); where that does
// not become good enough, the pieces themselves are the spline.

#pragma once

#include "core/base/tolerances.h"
#include "core/base/unbounded.h"
#include "core/base/work_limit.h"
#include "core/forms/surface.h"
#include "core/results/result.h"
#include "core/tracing/trace.h"

namespace blossom {

struct FitOptions {
  double tolerance = Tolerances{}.point;  ///< wanted agreement of the three images, model units
  double gap = 0;   ///< distance of the surfaces along the curve; the images agree no better
  double size = 1;  ///< diagonal of the larger surface: samples get chords within 1e-4 of it
  double most = kUnbounded;         ///< deviation of a curve that is still worth returning
  const WorkLimit* work = nullptr;  ///< when to give up; null: never
};

/// The curve of a chain: splines, samples, length, least angle and proven deviation. `ends`,
/// `closed` and `tangential` are left to the caller.
///
///   (1) ends, in space and in both charts, are those of the chain; a loop ends where it begins
///   (2) the derivative of order k is continuous at a knot of multiplicity 5 - k
///
/// returns   the deviation is about three tenths of the tolerance or less, unless rounding or the
///           depth of the halving prevents it: it then says what was reached.
///           A chain without any length gives no curve, and its length is not a number; nor does
///           one that the curve would leave by more than `most`, or for which it is too late
IntersectionCurve fitted(const ChainTracer& tracer, const BezierSurface& a, const BezierSurface& b,
                         const FitOptions& options);

}  // namespace blossom
