// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces with more knots, and so with shorter patches.

#pragma once

#include "core/forms/surface.h"

namespace blossom {

enum class Direction { U, V };

/// The same surface with one more knot.
///
///   point_at(result, uv) == point_at(surface, uv) to rounding
///
/// Neighbouring patches share their border's points bit for bit where they did so before, and the
/// new ones do. In a direction of angles weights are scaled, so that the law holds for both halves.
///
/// knot     the surface's own parameter, inside of a span
/// throws   InvalidInput if it is outside, or a knot already but for rounding
BezierSurface with_knot(const BezierSurface& surface, Direction direction, double knot);

}  // namespace blossom
