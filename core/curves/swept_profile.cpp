// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/curves/swept_profile.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/curves/curve_meeting.h"

namespace blossom {
namespace {

// Of the coordinates: poles of a meridian as near to its plane, and of its axis, are there to what
// a placement rounds and a file leaves.
constexpr double kInPlane = 0x1p-40;
constexpr double kFrameRounding = 0x1p-48;  // of the coordinates: some ten steps
constexpr double kAtEnd = 1e-9;             // of a curve: a run this near its end goes up to it
// Sine of the angle between axes above which surfaces are not compared: one within any tolerance
// in use has far less.
constexpr double kMostSine = 1e-3;

// The points of a curve in a frame; weights stay.
template <class Map>
CurveSpans mapped(CurveSpans curve, const Map& map) {
  for (CurveSpan& span : curve.spans)
    for (Vec4& p : span.curve.points) {
      const Vec3 q = map(projected(p));
      p = {q[0] * p[3], q[1] * p[3], q[2] * p[3], p[3]};
    }
  return curve;
}

double largest_coordinate(const CurveSpans& curve) {
  double largest = 0;
  for (const CurveSpan& span : curve.spans)
    for (const Vec4& p : span.curve.points) largest = std::max(largest, max_norm(projected(p)));
  return largest;
}

// The direction from an axis to the pole that is farthest from it; nothing if all are on it.
std::optional<Vec3> outwards(const CurveSpans& curve, const Vec3& centre, const Vec3& axis) {
  Vec3 farthest{};
  for (const CurveSpan& span : curve.spans)
    for (const Vec4& p : span.curve.points) {
      const Vec3 radial = across(projected(p) - centre, axis);
      if (norm(radial) > norm(farthest)) farthest = radial;
    }
  if (norm(farthest) <= kInPlane * std::max(largest_coordinate(curve), max_norm(centre))) return {};
  return unit(farthest);
}

bool ends_there(const Interval& domain, double parameter) {
  return std::min(std::abs(parameter - domain.from), std::abs(domain.to - parameter)) <=
         kAtEnd * length(domain);
}

// The largest gap of two curves that have runs in common and nothing else, up to where one of them
// ends; nothing of others.
std::optional<double> gap_of_one_curve(const CurveSpans& a, const CurveSpans& b,
                                       const Tolerances& tolerances) {
  IntersectionOptions options;
  options.tolerances = tolerances;
  options.threads = 1;
  const CurveIntersection found = meeting_of(a, b, options);
  if (found.status == Status::Stopped || found.overlaps.empty() || !found.points.empty()) return {};
  const auto is_run = [](const CurvePlace& place) { return place.kind == PlaceKind::Overlap; };
  if (!std::ranges::all_of(found.places, is_run)) return {};
  double gap = 0;
  for (const CurveOverlap& run : found.overlaps) {
    const bool whole = (ends_there(a.domain(), run.a.from) || ends_there(b.domain(), run.b.from)) &&
                       (ends_there(a.domain(), run.a.to) || ends_there(b.domain(), run.b.to));
    if (!run.proven || !whole) return {};
    gap = std::max(gap, run.gap_high);
  }
  return gap;
}

// The curve of b, of which the heights are over `foot_b`, as a's over `foot_a`.
std::optional<double> gap_of_turned(const SweptProfile& a, const SweptProfile& b, const Ball& ball,
                                    double sine, const Tolerances& tolerances) {
  const auto foot = [&](const SweptProfile& of) {
    return of.centre + dot(ball.centre - of.centre, of.axis) * of.axis;
  };
  const Vec3 foot_a = foot(a), foot_b = foot(b);
  const double moved = distance(foot_a, foot_b) + 0.5 * std::numbers::pi * sine *
                                                      (ball.radius + distance(foot_a, ball.centre));
  if (!(moved <= tolerances.point)) return {};
  const double sense = dot(a.axis, b.axis) < 0 ? -1 : 1;
  const double height_a = dot(foot_a - a.centre, a.axis);
  const double height_b = dot(foot_b - b.centre, b.axis);
  const CurveSpans of_b = mapped(b.curve, [&](const Vec3& p) {
    return Vec3{p[0], height_a + sense * (p[1] - height_b), 0};
  });
  const auto gap = gap_of_one_curve(a.curve, of_b, tolerances);
  if (!gap) return {};
  return *gap + moved;
}

// Both curves in the plane through the ball's centre across the axis of a.
std::optional<double> gap_of_moved(const SweptProfile& a, const SweptProfile& b, const Ball& ball,
                                   double sine, const Tolerances& tolerances) {
  const double moved = ball.radius * sine / std::sqrt(1 - sine * sine);
  if (!(moved <= tolerances.point)) return {};
  const Vec3 y_a = cross(a.axis, a.x), y_b = cross(b.axis, b.x);
  const Vec3 step = b.axis * (1 / dot(a.axis, b.axis));
  const CurveSpans of_b = mapped(b.curve, [&](const Vec3& p) {
    const Vec3 point = b.centre + p[0] * b.x + p[1] * y_b;
    const Vec3 from = point + dot(ball.centre - point, a.axis) * step - a.centre;
    return Vec3{dot(from, a.x), dot(from, y_a), 0};
  });
  // That of a was moved along its axis alone, which changes nothing.
  const auto gap = gap_of_one_curve(a.curve, of_b, tolerances);
  if (!gap) return {};
  return *gap + moved;
}

}  // namespace

std::optional<SweptProfile> turned_profile(const CurveSpans& curve, const Vec3& centre,
                                           const Vec3& axis) {
  const std::optional<Vec3> outer = outwards(curve, centre, axis);
  if (!outer) return {};
  const Vec3 out = *outer, side = cross(axis, out);
  const double rounding = kInPlane * std::max(largest_coordinate(curve), max_norm(centre));
  double off = 0;
  for (const CurveSpan& span : curve.spans)
    for (const Vec4& p : span.curve.points) {
      const Vec3 from = projected(p) - centre;
      off = std::max({off, std::abs(dot(from, side)), -dot(from, out)});
    }
  if (off > rounding) return {};
  SweptProfile profile{true, centre, axis, out, curve, curve.error + off};
  profile.curve = mapped(curve, [&](const Vec3& p) {
    return Vec3{std::max(dot(p - centre, out), 0.0), dot(p - centre, axis), 0};
  });
  profile.curve.error = 0;
  return profile;
}

std::optional<SweptProfile> moved_profile(const CurveSpans& curve, const Vec3& axis) {
  const Vec3 centre = projected(curve.spans.front().curve.points.front());
  const std::optional<Vec3> outer = outwards(curve, centre, axis);
  if (!outer) return {};
  const Vec3 out = *outer, side = cross(axis, out);
  SweptProfile profile{false, centre, axis, out, curve, curve.error};
  profile.curve = mapped(curve, [&](const Vec3& p) {
    return Vec3{dot(p - centre, out), dot(p - centre, side), 0};
  });
  profile.curve.error = 0;
  return profile;
}

std::optional<double> gap_of_one_sweep(const SweptProfile& a, const SweptProfile& b,
                                       const Ball& ball, const Tolerances& tolerances) {
  const double sine = norm(cross(a.axis, b.axis));
  if (a.turned != b.turned || sine > kMostSine) return {};
  const auto gap = a.turned ? gap_of_turned(a, b, ball, sine, tolerances)
                            : gap_of_moved(a, b, ball, sine, tolerances);
  if (!gap) return {};
  const double coordinate =
      std::max({largest_coordinate(a.curve), largest_coordinate(b.curve), max_norm(a.centre),
                max_norm(b.centre), max_norm(ball.centre), ball.radius});
  return *gap + a.error + b.error + kFrameRounding * coordinate;
}

}  // namespace blossom
