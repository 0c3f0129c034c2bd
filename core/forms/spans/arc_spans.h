// SPDX-License-Identifier: LGPL-2.1-or-later
// Arcs of circles, ellipses and hyperbolas as rational quadratic spans.

#pragma once

#include <vector>

#include "core/forms/curve_spans.h"
#include "core/math/interval.h"
#include "core/math/vec.h"

namespace blossom {

/// Where arcs are cut into the spans that rational curves and surfaces are made of.
enum class ArcCuts {
  Even,     ///< into as many equal spans as are at most quarters of a turn
  Shifted,  ///< a little off those places, to which symmetric shapes are often tangent
};

/// Part of a quarter of a turn: arcs longer by less need no further piece. A choice; files write
/// about ten digits of angles.
inline constexpr double kQuarterSlack = 1e-9;

/// Bezier points of w(t) (cos, sin, 1) over one span of an arc of the unit circle.
struct ArcSpan {
  Interval place;  ///< radians, less than half a turn
  double cosine[3];
  double sine[3];
  double weight[3];
};

/// The arc in as many spans as are at most quarters of a turn, if they are equal; a whole turn ends
/// in the bits it began with.
std::vector<ArcSpan> arc_spans(const Interval& angles, ArcCuts cuts = ArcCuts::Even);

/// origin + cos(t) a + sin(t) b for t in the range, radians.
CurveSpans ellipse_spans(const Vec3& origin, const Vec3& a, const Vec3& b, const Interval& range,
                         ArcCuts cuts = ArcCuts::Even);

/// origin + cosh(t) a + sinh(t) b, in equal spans at most 2 long: so middle weights are at most
/// cosh(1), about as far from 1 as those of arcs of a circle.
CurveSpans hyperbola_spans(const Vec3& origin, const Vec3& a, const Vec3& b, const Interval& range);

}  // namespace blossom
