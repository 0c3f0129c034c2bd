// SPDX-License-Identifier: LGPL-2.1-or-later
// A curve as Bezier spans with their places in its own parameters.
//
// This is what the engines take: every line, conic, Bezier and B-spline curve comes in this form,
// exactly; others within a stated error.

#pragma once

#include <vector>

#include "core/forms/curve.h"
#include "core/forms/surface.h"
#include "core/math/interval.h"
#include "core/math/vec.h"

namespace blossom {

/// One Bezier span of a curve with its place in the curve's own parameters.
struct CurveSpan {
  RationalBezierCurve curve;  ///< weight 1 everywhere when the curve is polynomial
  Interval place;
  ParameterLaw law = ParameterLaw::Linear;
};

/// Spans in the order of their places, each of which starts where the one before ends.
struct CurveSpans {
  std::vector<CurveSpan> spans;
  bool rational = false;  ///< true when some weight differs from 1
  double error = 0;       ///< distance to the curve it stands for, model units; 0 when exact

  Interval domain() const { return {spans.front().place.from, spans.back().place.to}; }
};

/// One Bezier curve with parameters 0 to 1.
CurveSpans curve_spans(RationalBezierCurve curve);
CurveSpans curve_spans(const BezierCurve& curve);

/// The point of the curve at its own parameter, clamped to the domain. Model units.
Vec3 point_at(const CurveSpans& curve, double parameter);

/// Throws InvalidInput, naming `name`, unless there is a span, places increase and follow each
/// other, degrees are in 1..kMaxDegree, all numbers are finite and all weights positive.
void validate(const CurveSpans& curve, const char* name);

}  // namespace blossom
