// SPDX-License-Identifier: LGPL-2.1-or-later
// Splines that run evenly along a straight line.

#pragma once

#include "core/forms/spline.h"
#include "core/plane/planar_curves.h"

namespace blossom {

/// Of the largest coordinate: rounding of fitted control points.
inline constexpr double kEvenLine = 1e-12;

/// Whether a spline is a straight line along which its parameter runs evenly, to kEvenLine of its
/// largest coordinates: the image of a circle round a cylinder's axis has as many spans as another
/// image of it needs.
bool is_even_line(const Spline2& spline);

/// The spans of the spline; one straight one if it is an even line.
PlanarCurve simplest_curve(const Spline2& spline);

}  // namespace blossom
