// SPDX-License-Identifier: LGPL-2.1-or-later
// Curves and surfaces without an exact Bezier form, interpolated, with a sampled error.
//
// Pieces are polynomials of degree 8 through the values in Chebyshev-Lobatto nodes, ends included:
// pieces that meet share the bits of their common values.

#pragma once

#include <functional>
#include <vector>

#include "core/forms/curve_spans.h"
#include "core/forms/surface.h"
#include "core/math/vec.h"

namespace blossom {

/// The curve between breaks, strictly increasing, at which it is not smooth or ends. A piece that
/// is off by more than the tolerance is halved, up to ten times.
///
/// value       the point at a parameter, finite
/// tolerance   model units
/// The result's `error` is twice the largest distance sampled, as samples may miss the largest one.
CurveSpans fitted_spans(const std::function<Vec3(double)>& value, const std::vector<double>& breaks,
                        double tolerance);

/// The surface between breaks in both directions, likewise. Rows or columns of patches that are
/// off are halved, in the direction in which the interpolation errs, those that are off most first,
/// until there are 96 of them. Where it jumps, as an offset does where the normal turns over, no
/// number of them helps: what is nearer than the jump then is near enough.
BezierSurface fitted_surface(const std::function<Vec3(double, double)>& value,
                             std::vector<double> u_breaks, std::vector<double> v_breaks,
                             double tolerance);

}  // namespace blossom
