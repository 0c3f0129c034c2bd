// SPDX-License-Identifier: LGPL-2.1-or-later
// Where a curve touches the wires of a face: one meeting each.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "core/topology/clipping/curve_clip.h"
#include "core/topology/clipping/curve_clip_detail.h"

namespace blossom {
namespace {

constexpr std::array kBetween{0.25, 0.5, 0.75};

const Coedge& coedge_of(const FaceTrims& trims, const TrimMeeting& meeting) {
  return trims
      .loops[static_cast<std::size_t>(meeting.loop)][static_cast<std::size_t>(meeting.coedge)];
}

// Where a curve passes the corner of two neighbouring coedges from one meeting to the next, within
// tolerance.
std::optional<double> at_corner(const FaceTrims& trims, const PlanarCurve& curve, double tolerance,
                                const TrimMeeting& a, const TrimMeeting& b) {
  const Coedge &of_a = coedge_of(trims, a), &of_b = coedge_of(trims, b);
  if (a.loop != b.loop) return {};
  const auto passed = [&](int corner) -> std::optional<double> {
    const Vec2& point = trims.corners[static_cast<std::size_t>(corner)];
    double at = std::clamp(nearest(curve, point).parameter, a.at, b.at);
    // What is nearest of a closed curve that begins there may be its end.
    for (const double end : {a.at, b.at})
      if (distance(point_at(curve, end), point) < distance(point_at(curve, at), point)) at = end;
    if (distance(point_at(curve, at), point) > tolerance) return {};
    return at;
  };
  std::optional<double> at;
  if (of_a.to == of_b.from) at = passed(of_a.to);
  if (!at && of_a.from == of_b.to) at = passed(of_a.from);
  return at;
}

// Whether a curve keeps within tolerance of an edge, or of two at their corner, from one meeting to
// the next, which are farther apart than that, but no farther than a touch may take: where it
// touches then: where the curve ends, half way or in the corner.
std::optional<double> one_touch_at(const FaceTrims& trims, const PlanarCurve& curve,
                                   double tolerance, const TrimMeeting& a, const TrimMeeting& b) {
  const Coedge &of_a = coedge_of(trims, a), &of_b = coedge_of(trims, b);
  const double length = chord_length(curve, {a.at, b.at});
  if (length <= tolerance || length > wire_touch_length(trims, tolerance)) return {};
  const bool keeps = std::all_of(kBetween.begin(), kBetween.end(), [&](double t) {
    const Vec2 point = point_at(curve, at(Interval{a.at, b.at}, t));
    return nearest(of_a.curve, point).distance <= tolerance ||
           nearest(of_b.curve, point).distance <= tolerance;
  });
  if (!keeps) return {};
  if (&of_a == &of_b)
    return a.at == curve.domain().from ? a.at
           : b.at == curve.domain().to ? b.at
                                       : 0.5 * (a.at + b.at);
  return at_corner(trims, curve, tolerance, a, b);
}

// Whether a curve ends there, but for the tolerance.
bool is_end(const PlanarCurve& curve, double t, double tolerance) {
  const Vec2 point = point_at(curve, t);
  return distance(point, point_at(curve, curve.domain().from)) <= tolerance ||
         distance(point, point_at(curve, curve.domain().to)) <= tolerance;
}

const Coedge& coedge_of(const FaceTrims& trims, const TrimRun& run) {
  return trims.loops[static_cast<std::size_t>(run.loop)][static_cast<std::size_t>(run.coedge)];
}

// The end of a run at which the curve or the edge ends, and not at the other one: there the curve
// has come to be farther than the tolerance from the edge.
std::optional<double> only_bound_end(const PlanarCurve& curve, const Coedge& edge,
                                     const TrimRun& run, double tolerance) {
  const bool from = is_end(curve, run.at.from, tolerance) ||
                    is_end(edge.curve, run.edge_parameters.from, tolerance);
  const bool to =
      is_end(curve, run.at.to, tolerance) || is_end(edge.curve, run.edge_parameters.to, tolerance);
  if (from == to) return {};
  return from ? run.at.from : run.at.to;
}

// Whether a curve leaves an edge all the way from one place to another: by a fourth power of the
// way it is a sixteenth of the distance away when half of it is done, less what both are off.
bool leaves(const PlanarCurve& curve, const Coedge& edge, double from, double to,
            double tolerance) {
  const auto off = [&](double part) {
    return nearest(edge.curve, point_at(curve, at(Interval{from, to}, part))).distance;
  };
  return off(0.5) - off(0) >= tolerance / 32;
}

// A curve that ends where it crosses an edge at a small angle, or touches it, keeps to it from
// there for no longer than a touch, or than a contact of the fourth order that it leaves: it meets
// the edge in its end, and does not run along it.
void shrink_ends_of_touches(const FaceTrims& trims, const PlanarCurve& curve, double tolerance,
                            ClippedCurve& found) {
  const double size = norm(trims.box.high - trims.box.low);
  const double longest = 4 * std::pow(tolerance * size * size * size, 0.25);
  std::erase_if(found.runs, [&](const TrimRun& run) {
    if (chord_length(curve, run.at) > longest) return false;
    const Coedge& edge = coedge_of(trims, run);
    const std::optional<double> end = only_bound_end(curve, edge, run, tolerance);
    if (!end) return false;
    const double other = *end == run.at.from ? run.at.to : run.at.from;
    if (chord_length(curve, run.at) > wire_touch_length(trims, tolerance) &&
        !leaves(curve, edge, *end, other, tolerance))
      return false;
    std::erase_if(found.meetings, [&](const TrimMeeting& meeting) {
      return meeting.loop == run.loop && meeting.coedge == run.coedge && meeting.at == other;
    });
    return true;
  });
}

// A curve that touches an edge may cross it twice by what curve or edge are off: one meeting, so
// that it stays whole there. Not where it runs along the edge.
void join_double_touches(const FaceTrims& trims, const PlanarCurve& curve, double tolerance,
                         ClippedCurve& found) {
  const auto has_run = [&](const TrimMeeting& a, const TrimMeeting& b) {
    return std::any_of(found.runs.begin(), found.runs.end(), [&](const TrimRun& run) {
      return run.at.from <= b.at && a.at <= run.at.to;
    });
  };
  std::vector<TrimMeeting> kept;
  for (const TrimMeeting& meeting : found.meetings) {
    std::optional<double> touch;
    if (!kept.empty() && !has_run(kept.back(), meeting))
      touch = one_touch_at(trims, curve, tolerance, kept.back(), meeting);
    if (!touch) {
      kept.push_back(meeting);
      continue;
    }
    TrimMeeting& last = kept.back();
    const PlanarFoot foot = nearest(coedge_of(trims, last).curve, point_at(curve, *touch));
    last = {*touch, last.loop, last.coedge, foot.parameter, {last.touch.from, meeting.touch.to}};
  }
  found.meetings = std::move(kept);
}

// A closed curve may touch an edge where it begins and ends: then it is whole there, too.
void join_touch_at_ends(const FaceTrims& trims, const PlanarCurve& curve, double tolerance,
                        ClippedCurve& found) {
  const Interval domain = curve.domain();
  if (found.meetings.size() < 2 || !found.runs.empty() ||
      distance(point_at(curve, domain.from), point_at(curve, domain.to)) > tolerance)
    return;
  TrimMeeting &first = found.meetings.front(), &last = found.meetings.back();
  if (first.at == domain.from || last.at == domain.to) return;
  const Coedge& of = coedge_of(trims, first);
  if (&of != &coedge_of(trims, last)) return;
  double length = 0;
  for (const Interval& part : {Interval{domain.from, first.at}, {last.at, domain.to}}) {
    Vec2 before = point_at(curve, part.from);
    for (const double t : {0.25, 0.5, 0.75, 1.0}) {
      const Vec2 point = point_at(curve, at(part, t));
      if (nearest(of.curve, point).distance > tolerance) return;
      length += distance(before, point);
      before = point;
    }
  }
  if (length > wire_touch_length(trims, tolerance)) return;
  const double place = nearest(of.curve, point_at(curve, domain.from)).parameter;
  first = {domain.from, first.loop, first.coedge, place, {domain.from, first.at}};
  last = {domain.to, last.loop, last.coedge, place, {last.at, domain.to}};
}

}  // namespace

void join_touches(const FaceTrims& trims, const PlanarCurve& curve, double tolerance,
                  ClippedCurve& found) {
  shrink_ends_of_touches(trims, curve, tolerance, found);
  join_double_touches(trims, curve, tolerance, found);
  join_touch_at_ends(trims, curve, tolerance, found);
}

}  // namespace blossom
