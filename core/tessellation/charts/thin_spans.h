// SPDX-License-Identifier: LGPL-2.1-or-later
// Spans that hardly move a surface are taken out of it.
//
// Modellers extend surfaces to their edges by a span of 1e-8 or so, and fits refine their knots
// where what they follow is not smooth. In such spans control points differ by rounding alone, and
// derivatives are rounding over a tiny length: of any size, and so are bounds that follow from
// them.

#pragma once

#include "core/forms/surface.h"

namespace blossom {

/// Takes out runs of spans in u and v over which no point moves by more than `thin`; at least one
/// span stays in each direction. At the start the surface then ends at the run's other border, and
/// parameters beyond it are clamped. Elsewhere the span before is stretched over the run, up to its
/// other border, so that the surface has no gap. What moves is added to the error.
///
/// thin   model units
void drop_thin_spans(BezierSurface& surface, double thin);

}  // namespace blossom
