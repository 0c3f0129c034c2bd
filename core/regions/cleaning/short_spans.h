// SPDX-License-Identifier: LGPL-2.1-or-later
// Trims without spans that are shorter than they can be told.

#pragma once

#include "core/forms/surface.h"
#include "core/plane/planar_curves.h"
#include "core/regions/trimmed_chart.h"

namespace blossom {

/// The curve with fewer spans that are short in space: neighbours become one through points of
/// both, if no point moves by more than a distance. Arcs end where spans do, and triangles on arcs
/// hardly longer than they are moved would fold over.
///
/// curve     in the surface's own parameters
/// within    model units, in space, at equal parameters and at samples
PlanarCurve without_short_spans(const BezierSurface& surface, PlanarCurve curve, double within);

/// The chart with borders of such curves.
TrimmedChart without_short_spans(const BezierSurface& surface, TrimmedChart chart, double within);

}  // namespace blossom
