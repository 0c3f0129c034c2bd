// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/plane/planar_crossings.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "core/base/errors.h"
#include "core/curves/contact_length.h"
#include "core/curves/curve_meeting.h"
#include "core/math/functions/sign_change.h"

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

// How far a point of the first curve is to the left of the second one, and from where on that.
struct SideFoot {
  double left = 0;
  double at = 0;  // parameter of the second curve
};

SideFoot side_foot(const PlanarCurve& a, const PlanarCurve& b, double parameter) {
  const Vec2 point = point_at(a, parameter);
  const double at = nearest(b, point).parameter;
  const PlanarJet jet = jet_at(b, at);
  return {cross(unit(jet.first), point - jet.point), at};
}

// Where the curves change sides along a contact: parameters of the first curve. A side is what
// exceeds the margin at a sample. A contact may be longer than the second curve: beyond its end
// they change sides where their tangents cross, which is no common point.
std::vector<double> side_changes(const PlanarCurve& a, const PlanarCurve& b,
                                 const Interval& contact, double margin, double tolerance) {
  constexpr int kSamples = 32;
  constexpr double kPlace = 1e-9;  // of the contact
  const auto left = [&](double parameter) { return side_foot(a, b, parameter).left; };
  std::vector<double> changes;
  double before = contact.from, left_before = 0;
  for (int i = 0; i <= kSamples; ++i) {
    const double here = at(contact, static_cast<double>(i) / kSamples), left_here = left(here);
    if (std::abs(left_here) <= margin) continue;
    if (left_here * left_before < 0) {
      SignChange change{before, here};
      if (left_before > 0) std::swap(change.below, change.above);
      const SignChange found = narrowed(left, change, std::min(left_before, left_here),
                                        std::max(left_before, left_here), kPlace * length(contact));
      const double middle = 0.5 * (found.below + found.above);
      if (nearest(b, point_at(a, middle)).distance <= tolerance) changes.push_back(middle);
    }
    before = here;
    left_before = left_here;
  }
  return changes;
}

// The common points. A contact too long for a point is what changes sides in it, where anything
// does: a contact of high order may hold several crossings.
std::vector<CurvePoint> points_of(const PlanarCurve& a, const PlanarCurve& b,
                                  const CurveIntersection& found, double tolerance) {
  std::vector<CurvePoint> points = found.points;
  const double longest = curve_touch_length(tolerance, std::min(size(box_of(a)), size(box_of(b))));
  for (const CurvePlace& place : found.places) {
    if (place.kind != PlaceKind::Touch && place.kind != PlaceKind::Tangential) continue;
    if (!(chord_length(a, place.a) > longest)) continue;
    const std::vector<double> changes =
        side_changes(a, b, place.a, found.certificate.rounding_bound, tolerance);
    if (changes.empty()) continue;
    std::erase_if(points, [&](const CurvePoint& point) {
      return !point.proven && place.a.from <= point.a && point.a <= place.a.to;
    });
    for (const double at : changes) {
      const Vec2 here = point_at(a, at);
      if (std::ranges::none_of(points, [&](const CurvePoint& point) {
            return distance(point_at(a, point.a), here) <= tolerance;
          }))
        points.push_back(
            {{here[0], here[1], 0}, at, side_foot(a, b, at).at, false, false, {at, at}, {}});
    }
  }
  return points;
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
  for (const CurvePoint& point : points_of(a, b, found, tolerance))
    add(point.a, point.b, point.tangential);
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
