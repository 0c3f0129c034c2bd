// SPDX-License-Identifier: LGPL-2.1-or-later
// Two curves, or one with itself: the steps from cells to the result. Users call
// `core/curve_intersection.h`, which describes it.

#pragma once

#include "core/forms/curve_spans.h"
#include "core/results/curve_result.h"
#include "core/results/options.h"

namespace blossom {

/// throws  InvalidInput if a curve is not well formed or the tolerance is not positive
CurveIntersection meeting_of(const CurveSpans& a, const CurveSpans& b,
                             const IntersectionOptions& options);
CurveIntersection meeting_of_itself(const CurveSpans& curve, const IntersectionOptions& options);

}  // namespace blossom
