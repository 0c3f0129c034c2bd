// SPDX-License-Identifier: LGPL-2.1-or-later
// What the trims of a face leave of a curve.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/base/unbounded.h"
#include "core/topology/clipping/curve_clip.h"
#include "core/topology/clipping/curve_clip_detail.h"

namespace blossom {
namespace {

// Along an oblique curve, a meeting is known that much worse than the distance that counts.
constexpr double kMeetingReach = 10 * kOnWire;

bool holds(const PlanarBox& box, const PlanarBox& other) {
  for (int k = 0; k < 2; ++k) {
    const double error = kNaturalError * (box.high[k] - box.low[k]);
    if (other.low[k] < box.low[k] - error || other.high[k] > box.high[k] + error) return false;
  }
  return true;
}

// Between neighbouring parameters the curve is inside or outside as a whole.
std::vector<double> divisions(const PlanarCurve& curve, const ClippedCurve& found) {
  const Interval domain = curve.domain();
  std::vector<double> at{domain.from, domain.to};
  for (const TrimMeeting& meeting : found.meetings) at.push_back(meeting.at);
  for (const TrimRun& run : found.runs) at.insert(at.end(), {run.at.from, run.at.to});
  std::sort(at.begin(), at.end());
  at.erase(std::unique(at.begin(), at.end()), at.end());
  return at;
}

bool on_run(const ClippedCurve& found, double parameter) {
  return std::any_of(found.runs.begin(), found.runs.end(), [&](const TrimRun& run) {
    return run.at.from <= parameter && parameter <= run.at.to;
  });
}

void append(std::vector<Interval>& intervals, const Interval& next) {
  if (!intervals.empty() && intervals.back().to >= next.from)
    intervals.back().to = std::max(intervals.back().to, next.to);
  else
    intervals.push_back(next);
}

// The largest tolerance of the wires that a piece of a curve keeps to; none if it leaves them.
std::optional<double> kept_tolerance(const FaceTrims& trims, const PlanarCurve& curve,
                                     const Interval& piece) {
  double largest = 0;
  for (const double t : {0.5, 0.25, 0.75, 0.0, 1.0}) {
    const Coedge* const coedge = coedge_at(trims, point_at(curve, at(piece, t)));
    if (coedge == nullptr) return {};
    largest = std::max(largest, kOnWire + coedge->tolerance);
  }
  return largest;
}

// Pieces between neighbouring divisions along wires. A curve that keeps within tolerance of wires
// may meet them only here and there; so does what crosses or touches them, but is not long then.
std::vector<char> along_wires(const FaceTrims& trims, const PlanarCurve& curve,
                              const ClippedCurve& found, const std::vector<double>& at) {
  const std::size_t pieces = at.size() - 1;
  std::vector<char> along(pieces);
  for (std::size_t i = 0, next = 0; i < pieces; i = std::max(next, i + 1)) {
    double length = 0, tolerance = 0;
    for (next = i; next < pieces; ++next) {
      const Interval piece{at[next], at[next + 1]};
      const auto kept = kept_tolerance(trims, curve, piece);
      if (!kept) break;
      length += chord_length(curve, piece);
      tolerance = std::max(tolerance, *kept);
    }
    const bool is_long = length > wire_touch_length(trims, tolerance);
    for (std::size_t k = i; k < next; ++k) along[k] = is_long;
  }
  for (std::size_t i = 0; i < pieces; ++i)
    along[i] = along[i] || on_run(found, 0.5 * (at[i] + at[i + 1]));
  return along;
}

// Intervals inside or, if asked, along wires; those of one kind are joined.
std::vector<Interval> inside_of(const FaceTrims& trims, const PlanarCurve& curve,
                                const ClippedCurve& found, bool with_runs) {
  const std::vector<double> at = divisions(curve, found);
  const std::vector<char> along =
      with_runs ? along_wires(trims, curve, found, at) : std::vector<char>(at.size());
  std::vector<Interval> inside;
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    const double middle = 0.5 * (at[i] + at[i + 1]);
    const bool on_wire = with_runs ? along[i] : on_run(found, middle);
    if (on_wire ? with_runs : is_inside(trims, point_at(curve, middle)))
      append(inside, {at[i], at[i + 1]});
  }
  return inside;
}

void meet(const FaceTrims& trims, const PlanarCurve& curve, double tolerance, int loop, int index,
          ClippedCurve& found) {
  const Coedge& coedge =
      trims.loops[static_cast<std::size_t>(loop)][static_cast<std::size_t>(index)];
  const PlanarCrossings common = crossings(curve, coedge.curve, tolerance);
  for (const PlanarCrossing& point : common.points)
    found.meetings.push_back({point.a, loop, index, point.b, {point.a, point.a}});
  for (const PlanarOverlap& run : common.overlaps)
    found.runs.push_back({run.a, loop, index, run.b});
  found.complete = found.complete && common.complete;
}

// Edges that meet in a vertex of large tolerance may end far apart in the chart. What goes through
// the gap between them meets the wire at that end of the second one.
void meet_gap(const FaceTrims& trims, const PlanarCurve& curve, double tolerance, int loop,
              int index, ClippedCurve& found) {
  const Coedge& coedge =
      trims.loops[static_cast<std::size_t>(loop)][static_cast<std::size_t>(index)];
  const Interval domain = coedge.curve.domain();
  const double start = coedge.reversed ? domain.to : domain.from;
  const Vec2 from = trims.corners[static_cast<std::size_t>(coedge.from)];
  const Vec2 to = point_at(coedge.curve, start);
  if (distance(from, to) <= tolerance) return;
  const PlanarCrossings common = crossings(curve, planar_line(from, to, {0, 1}), tolerance);
  for (const PlanarCrossing& point : common.points)
    found.meetings.push_back({point.a, loop, index, start, {point.a, point.a}});
  found.complete = found.complete && common.complete;
}

void sort(std::vector<Interval>& intervals) {
  std::sort(intervals.begin(), intervals.end(),
            [](const Interval& a, const Interval& b) { return a.from < b.from; });
}

std::vector<Interval> united(std::vector<Interval> intervals) {
  sort(intervals);
  std::vector<Interval> joined;
  for (const Interval& interval : intervals) append(joined, interval);
  return joined;
}

PlanarBox box_of_poles(const Spline2& chart, const Vec2& scale) {
  PlanarBox box{{kUnbounded, kUnbounded}, {-kUnbounded, -kUnbounded}};
  for (const Vec2& p : chart.points)
    for (int k = 0; k < 2; ++k) {
      box.low[k] = std::min(box.low[k], p[k] * scale[k]);
      box.high[k] = std::max(box.high[k], p[k] * scale[k]);
    }
  return box;
}

// Inside or outside as a whole where no wire comes near the box of the poles. Of a chart with
// periods other moves of the box may be inside.
PartSide side_of_poles(const FaceTrims& trims, const Spline2& chart, double tolerance) {
  const PlanarBox box = box_of_poles(chart, trims.scale);
  const auto range = [&](int k) {
    return Interval{(box.low[k] - tolerance) / trims.scale[k],
                    (box.high[k] + tolerance) / trims.scale[k]};
  };
  const PartSide side = part_side(trims, range(0), range(1));
  return side == PartSide::Outside && trims.period != Vec2{} ? PartSide::Mixed : side;
}

// Makes parts that are nowhere farther than tolerance from a wire, and no longer than a touch may
// be, intervals without length.
void shrink_touches(const FaceTrims& trims, const PlanarCurve& curve,
                    std::vector<Interval>& inside) {
  for (Interval& part : inside) {
    if (chord_length(curve, part) > wire_touch_length(trims, kOnWire)) continue;
    const bool touches = [&] {
      for (const double t : {0.5, 0.25, 0.75})
        if (coedge_at(trims, point_at(curve, at(part, t)), Wires::AsTheyAre) == nullptr)
          return false;
      return !covers_edges(trims, point_at(curve, part.from), point_at(curve, part.to));
    }();
    if (touches) part = {at(part, 0.5), at(part, 0.5)};
  }
}

// Adds points, as intervals without length, but those in an interval or at its end.
void add_touches(const PlanarCurve& curve, const std::vector<double>& points,
                 std::vector<Interval>& inside) {
  const auto same = [&](double s, double t) {
    return distance(point_at(curve, s), point_at(curve, t)) <= kMeetingReach;
  };
  for (const double t : points)
    if (std::none_of(inside.begin(), inside.end(), [&](const Interval& part) {
          return (part.from <= t && t <= part.to) || same(part.from, t) || same(part.to, t);
        }))
      inside.push_back({t, t});
}

// Four pieces of each span.
std::vector<double> quarters(const PlanarCurve& curve) {
  std::vector<double> at;
  for (const PlanarSpan& span : curve.spans)
    for (const double part : {0.0, 0.25, 0.5, 0.75}) at.push_back(blossom::at(span.place, part));
  at.push_back(curve.domain().to);
  return at;
}

// Whether an edge keeps to a curve between its places next to two points.
bool keeps_to(const Coedge& edge, const Vec2& p, const Vec2& q, const PlanarCurve& curve) {
  const double s = nearest(edge.curve, p).parameter, t = nearest(edge.curve, q).parameter;
  const std::vector<double> places = quarters(edge.curve);
  return std::ranges::all_of(places, [&](double at) {
    return at <= std::min(s, t) || at >= std::max(s, t) ||
           nearest(curve, point_at(edge.curve, at)).distance <= kOnWire + edge.tolerance;
  });
}

// Whether the wires that a curve keeps to at two places lead from one to the other along it: one
// edge, or two with a common corner on the curve. A wire may leave it for a bay in between.
bool wires_go_on(const FaceTrims& trims, const PlanarCurve& curve, double s, double t) {
  const Vec2 p = point_at(curve, s), q = point_at(curve, t);
  const Coedge *const a = coedge_at(trims, p), *const b = coedge_at(trims, q);
  if (a == nullptr || b == nullptr) return false;
  if (a == b) return keeps_to(*a, p, q, curve);
  if (a->to != b->from && a->from != b->to) return false;
  const Vec2& corner = trims.corners[static_cast<std::size_t>(a->to == b->from ? a->to : a->from)];
  const PlanarFoot foot = nearest(curve, corner);
  return foot.distance <= kOnWire + std::max(a->tolerance, b->tolerance) && s <= foot.parameter &&
         foot.parameter <= t && keeps_to(*a, p, corner, curve) && keeps_to(*b, corner, q, curve);
}

// Whether all of a curve keeps to wires. Where it meets them does not matter then, and takes long
// to find out for one that is about as far from them as may count as a meeting.
bool is_along_wires(const FaceTrims& trims, const PlanarCurve& curve) {
  if (!kept_tolerance(trims, curve, curve.domain())) return false;
  const std::vector<double> places = quarters(curve);
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
    if (!wires_go_on(trims, curve, places[i], places[i + 1])) return false;
  const std::vector<char> along = along_wires(trims, curve, {}, places);
  return std::find(along.begin(), along.end(), 0) == along.end();
}

// What of a curve lies inside or touches wires, where it lies.
std::vector<Interval> parts_in(const FaceTrims& trims, const PlanarCurve& curve, double tolerance) {
  if (is_along_wires(trims, curve)) return {curve.domain()};
  const ClippedCurve found = clipped(trims, curve, std::max(tolerance, kOnWire));
  std::vector<Interval> parts = inside_of(trims, curve, found, true);
  std::vector<double> meetings;
  for (const TrimMeeting& meeting : found.meetings) meetings.push_back(meeting.at);
  add_touches(curve, meetings, parts);
  shrink_touches(trims, curve, parts);
  return parts;
}

Vec3 in_space(const FaceTrims& trims, const Vec2& point) {
  return trims.jet({point[0] / trims.scale[0], point[1] / trims.scale[1]}).point;
}

// What no point of a coedge is nearer than, in the chart.
double least_distance(const Coedge& coedge, const Vec2& point) {
  double least = kInfinity;
  for (const PlanarBox& box : coedge.boxes) {
    Vec2 past;
    for (int k = 0; k < 2; ++k)
      past[k] = std::max({box.low[k] - point[k], point[k] - box.high[k], 0.0});
    least = std::min(least, norm(past));
  }
  return least;
}

// The place of a wire that is nearest in the chart. Coedges are looked at only where their boxes
// come nearer than what is known: first the one whose boxes come nearest.
Vec2 foot_on_wires(const FaceTrims& trims, const Vec2& point) {
  double least = kInfinity;
  Vec2 foot = point;
  const auto look_at = [&](const Coedge& coedge) {
    const PlanarFoot near = nearest(coedge.curve, point);
    if (near.distance >= least) return;
    least = near.distance;
    foot = point_at(coedge.curve, near.parameter);
  };
  const Coedge* first = nullptr;
  double bound = kInfinity;
  for (const auto& loop : trims.loops)
    for (const Coedge& coedge : loop)
      if (const double of = least_distance(coedge, point); of < bound) {
        first = &coedge;
        bound = of;
      }
  if (first != nullptr) look_at(*first);
  for (const auto& loop : trims.loops)
    for (const Coedge& coedge : loop)
      if (&coedge != first && least_distance(coedge, point) < least) look_at(coedge);
  return foot;
}

// The distance in space from the wire that is nearest in the chart.
double distance_to_wires(const FaceTrims& trims, const Vec2& point) {
  return distance(in_space(trims, point), in_space(trims, foot_on_wires(trims, point)));
}

}  // namespace

bool covers_edges(const FaceTrims& trims, const Vec2& from, const Vec2& to) {
  const auto is_corner = [&](const Vec2& point) {
    return std::ranges::any_of(
        trims.corners, [&](const Vec2& corner) { return distance(corner, point) <= kOnWire; });
  };
  return distance(from, to) > 2 * kOnWire && is_corner(from) && is_corner(to);
}

double wire_touch_length(const FaceTrims& trims, double tolerance) {
  constexpr double kWireTouch = 4;  // squared: 8 times 2
  return kWireTouch * std::sqrt(tolerance * norm(trims.box.high - trims.box.low));
}

ClippedCurve clipped(const FaceTrims& trims, const PlanarCurve& curve, double tolerance) {
  ClippedCurve found;
  for (std::size_t loop = 0; loop < trims.loops.size(); ++loop)
    for (std::size_t i = 0; i < trims.loops[loop].size(); ++i) {
      meet(trims, curve, tolerance, static_cast<int>(loop), static_cast<int>(i), found);
      if (trims.largest_gap > tolerance)
        meet_gap(trims, curve, tolerance, static_cast<int>(loop), static_cast<int>(i), found);
    }
  std::sort(found.meetings.begin(), found.meetings.end(),
            [](const TrimMeeting& a, const TrimMeeting& b) { return a.at < b.at; });
  join_touches(trims, curve, tolerance, found);
  found.inside = inside_of(trims, curve, found, false);
  return found;
}

std::vector<Interval> clip_to_trims(const FaceTrims& trims, const Spline2& chart,
                                    double tolerance) {
  // Most curves on whole surfaces need not be made: all poles are in the box.
  const PlanarBox poles = box_of_poles(chart, trims.scale);
  if (trims.natural && holds(trims.box, poles)) {
    std::vector<Interval> whole{chart.domain()};
    if (norm(poles.high - poles.low) <= wire_touch_length(trims, kOnWire))
      shrink_touches(trims, chart_curve(trims, chart), whole);
    return whole;
  }
  const PartSide side = side_of_poles(trims, chart, tolerance);
  if (side == PartSide::Outside) return {};
  if (side == PartSide::Inside) return {chart.domain()};
  const PlanarCurve curve = chart_curve(trims, chart);
  if (trims.natural && holds(trims.box, box_of(curve))) return {curve.domain()};
  std::vector<Interval> inside;
  std::vector<double> touches;
  for (const Vec2& shift : period_shifts(trims, curve))
    for (const Interval& part : parts_in(trims, transformed(curve, {1, 1}, shift), tolerance)) {
      if (part.from < part.to)
        inside.push_back(part);
      else
        touches.push_back(part.from);
    }
  inside = united(std::move(inside));
  add_touches(curve, touches, inside);
  sort(inside);
  return inside;
}

std::optional<double> distance_along_wires(const FaceTrims& trims, const Spline2& chart,
                                           const std::vector<ChartSample>& samples) {
  if (trims.natural || side_of_poles(trims, chart, 0) != PartSide::Mixed) return {};
  const PlanarCurve curve = chart_curve(trims, chart);
  const std::vector<double> places = quarters(curve);
  std::optional<double> largest;
  for (const Vec2& shift : period_shifts(trims, curve)) {
    const std::vector<char> along =
        along_wires(trims, transformed(curve, {1, 1}, shift), {}, places);
    for (std::size_t i = 0; i < along.size(); ++i) {
      if (!along[i]) continue;
      largest = std::max(largest.value_or(0), 0.0);
      for (const auto& [t, uv] : samples)
        if (places[i] <= t && t <= places[i + 1])
          largest = std::max(
              *largest, distance_to_wires(
                            trims, Vec2{uv[0] * trims.scale[0], uv[1] * trims.scale[1]} + shift));
    }
  }
  return largest;
}

double distance_outwards(const FaceTrims& trims, const Vec2& uv) {
  double least = kInfinity;
  PlanarBox point{{uv[0] * trims.scale[0], uv[1] * trims.scale[1]}, {}};
  point.high = point.low;
  if (part_side(trims, {uv[0], uv[0]}, {uv[1], uv[1]}) == PartSide::Inside) return 0;
  for (const double turn_u : {0.0, trims.period[0], -trims.period[0]})
    for (const double turn_v : {0.0, trims.period[1], -trims.period[1]})
      least = std::min(least, distance_to_wires(trims, point.low + Vec2{turn_u, turn_v}));
  return least;
}

}  // namespace blossom
