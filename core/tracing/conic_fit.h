// SPDX-License-Identifier: LGPL-2.1-or-later
// The line or conic through points of an intersection curve.
//
// Where two planes, cylinders, cones, spheres or tori meet in a special position the curve is often
// a conic, and so is many a section of a swept surface. No type of surface is asked for: the traced
// points lie on a conic to rounding, or they do not. That alone is no proof; how far the conic
// leaves the surfaces along its whole length is proven after the charts are fitted
// (`core/tracing/deviation.h`).

#pragma once

#include <optional>
#include <span>

#include "core/forms/conic.h"
#include "core/tracing/trace.h"

namespace blossom {

/// The simplest of line, circle, parabola, ellipse and hyperbola that passes all points.
///
/// points    at least 6, in order along the curve and spread over it, model units
/// slack     largest distance of a point from the curve, model units
/// returns   its parameter grows along the points, by less than half a turn from each to the next;
///           nothing if none passes so near
///
/// Source: the conic through five points is one of the pencil through four of them.
std::optional<Conic> conic_through(std::span<const Vec3> points, double slack);

/// The conic that a chain's curve seems to be: traced points lie on it within `slack`. A circle
/// begins at parameter 0, an ellipse at one in [0, pi).
std::optional<Conic> conic_along(const ChainTracer& tracer, double slack);

}  // namespace blossom
