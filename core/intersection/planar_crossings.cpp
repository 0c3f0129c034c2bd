// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/intersection/planar_crossings.h"

#include <algorithm>
#include <cmath>

#include "core/base/errors.h"
#include "core/intersection/curve_meeting.h"

namespace blossom {
namespace {

CurveSpans lifted(const PlanarCurve& curve) {
  CurveSpans result;
  for (const PlanarSpan& span : curve.spans) {
    CurveSpan lifted{{}, span.place, span.law};
    for (const Vec3& p : span.curve.points) {
      lifted.curve.points.push_back({p[0], p[1], 0, p[2]});
      result.rational = result.rational || p[2] != 1;
    }
    result.spans.push_back(std::move(lifted));
  }
  return result;
}

bool apart(const PlanarBox& a, const PlanarBox& b, double tolerance) {
  for (int k = 0; k < 2; ++k)
    if (a.low[k] > b.high[k] + tolerance || b.low[k] > a.high[k] + tolerance) return true;
  return false;
}

// The end of the curve that the point at a parameter cannot be told from, or the parameter.
double moved_to_end(const PlanarCurve& curve, double parameter, double tolerance) {
  const Interval domain = curve.domain();
  const Vec2 point = point_at(curve, parameter);
  for (const double end : {domain.from, domain.to})
    if (distance(point, point_at(curve, end)) <= tolerance &&
        distance(point, point_at(curve, 0.5 * (parameter + end))) <= tolerance)
      return end;
  return parameter;
}

}  // namespace

PlanarCrossings crossings(const PlanarCurve& a, const PlanarCurve& b, double tolerance,
                          long budget) {
  if (!(tolerance > 0)) throw InvalidInput("crossings: the tolerance must be positive");
  if (a.spans.empty() || b.spans.empty()) throw InvalidInput("crossings: a curve has no span");
  if (apart(box_of(a), box_of(b), tolerance)) return {};
  IntersectionOptions options;
  options.tolerances.point = tolerance;
  options.budget = budget;
  const CurveIntersection found = meeting_of(lifted(a), lifted(b), options);
  PlanarCrossings result;
  result.complete = found.status != Status::Stopped;
  const auto add = [&](double at_a, double at_b, bool tangential) {
    const double on_a = moved_to_end(a, at_a, tolerance);
    result.points.push_back(
        {on_a, moved_to_end(b, at_b, tolerance), point_at(a, on_a), tangential});
  };
  for (const CurvePoint& point : found.points) add(point.a, point.b, point.tangential);
  for (const CurveOverlap& run : found.overlaps) {
    result.overlaps.push_back({run.a, run.b});
    add(run.a.from, run.b.from, false);
    add(run.a.to, run.b.to, false);
  }
  std::sort(result.points.begin(), result.points.end(),
            [](const PlanarCrossing& x, const PlanarCrossing& y) { return x.a < y.a; });
  return result;
}

}  // namespace blossom
