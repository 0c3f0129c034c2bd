// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/plane/planar_crossings.h"

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <utility>

#include "core/base/errors.h"
#include "core/curves/curve_meeting.h"

namespace blossom {
namespace {

// Of the tolerance: spans that follow each other are one chord while they need no larger box. What
// bends sharply in another chart has thousands of spans in reach of one point, and each of them
// would be compared with each of the other curve's.
constexpr double kChordBox = 1.0 / 16;

double size(const PlanarBox& box) {
  return std::max(box.high[0] - box.low[0], box.high[1] - box.low[1]);
}

// The first span after `from` that no longer lies in one chord's box with those before it.
std::size_t end_of_chord(const PlanarCurve& curve, std::size_t from, double longest) {
  PlanarBox box = box_of(curve.spans[from].curve.points);
  std::size_t end = from + 1;
  for (; end < curve.spans.size(); ++end) {
    box = united(box, box_of(curve.spans[end].curve.points));
    if (!(size(box) <= longest)) break;
  }
  return end;
}

void add_lifted(const PlanarSpan& span, CurveSpans& result) {
  CurveSpan lifted{{}, span.place, span.law};
  for (const Vec3& p : span.curve.points) {
    lifted.curve.points.push_back({p[0], p[1], 0, p[2]});
    result.rational = result.rational || p[2] != 1;
  }
  result.spans.push_back(std::move(lifted));
}

// The curve in space, its least spans joined. Each lies within the diagonal of its chord's box.
CurveSpans lifted(const PlanarCurve& curve, double tolerance) {
  const double longest = kChordBox * tolerance;
  CurveSpans result;
  for (std::size_t i = 0, end = 0; i < curve.spans.size(); i = end) {
    const PlanarSpan& first = curve.spans[i];
    end = end_of_chord(curve, i, longest);
    if (end == i + 1) {
      add_lifted(first, result);
      continue;
    }
    const PlanarSpan& last = curve.spans[end - 1];
    add_lifted({{{first.curve.points.front(), last.curve.points.back()}},
                {first.place.from, last.place.to}},
               result);
    result.error = std::numbers::sqrt2 * longest;
  }
  return result;
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
  if (are_disjoint(box_of(a), box_of(b), tolerance)) return {};
  IntersectionOptions options;
  options.tolerances.point = tolerance;
  options.budget = budget;
  const CurveIntersection found = meeting_of(lifted(a, tolerance), lifted(b, tolerance), options);
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
