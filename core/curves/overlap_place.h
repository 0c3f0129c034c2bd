// SPDX-License-Identifier: LGPL-2.1-or-later
// The place in which a curve runs along another one or in a surface.

#pragma once

#include "core/cells/curve_cells.h"
#include "core/math/interval.h"
#include "core/results/curve_result.h"

namespace blossom {

/// A place whose box, relative to the origin of the cells, has all spans of the curve that reach
/// into a stretch of it.
///
/// at          parameters of the stretch, increasing
/// gap_high    a bound on the distance in it, model units
/// returns     the place without the parameters on the other side
CurvePlace overlap_place(const CurveTree& curve, const Interval& at, double gap_high);

}  // namespace blossom
