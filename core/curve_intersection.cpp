// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/curve_intersection.h"

#include "core/curves/curve_meeting.h"

namespace blossom {

CurveIntersection intersect(const CurveSpans& a, const CurveSpans& b,
                            const IntersectionOptions& options) {
  return meeting_of(a, b, options);
}

CurveIntersection self_intersections(const CurveSpans& curve, const IntersectionOptions& options) {
  return meeting_of_itself(curve, options);
}

}  // namespace blossom
