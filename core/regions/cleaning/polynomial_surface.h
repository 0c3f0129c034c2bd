// SPDX-License-Identifier: LGPL-2.1-or-later
// A rational surface as polynomial patches in its own parameters, within a bound.
//
// Where surfaces of different weights are to share the control points of a common side, they have
// to be polynomial first.

#pragma once

#include "core/forms/surface.h"

namespace blossom {

/// The surface with weights 1 and linear parameters: interpolated at extreme points of spans that
/// are halved until the bound holds. A polynomial surface comes back as it is, but for narrow spans
/// (narrow_spans.h), which any surface loses.
///
///   (1) point_at(result, uv) is within result.error of point_at(surface, uv), for equal uv
///   (2) neighbouring patches share the points of their border bit for bit
///
/// accuracy   error: that of the surface itself, and a bound for the interpolation: along angles by
///            the remainder, else by comparing coefficients of X and w P. Not above the surface's
///            own plus the tolerance, unless 64 parts of a span do not do or narrow spans are long
///            in space
/// throws     InvalidInput if the tolerance is not positive or the surface is not well formed
///
/// Source: Davis 1963 for the remainder.
BezierSurface polynomial_surface(const BezierSurface& surface, double tolerance);

}  // namespace blossom
