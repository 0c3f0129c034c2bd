// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/topology/clipping/clipped_result.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "core/forms/conic.h"
#include "core/forms/spline.h"
#include "core/results/contact_places.h"
#include "core/topology/chart_projector.h"
#include "core/topology/clipping/arcs_past_border.h"
#include "core/topology/clipping/curve_clip.h"
#include "core/topology/clipping/shallow_ends.h"

namespace blossom {
namespace {

constexpr double kSamePoint = 1e-6;  // contacts as near as this are one, model units
constexpr std::array kAlong{0.0, 0.25, 0.5, 0.75, 1.0};  // samples of what may run along a wire

SurfacePoint point_of(const IntersectionCurve& curve, double t) {
  return {point_at(curve.curve, t), point_at(curve.chart_a, t), point_at(curve.chart_b, t)};
}

// Parameters a step nearer to a point; the same ones where that comes no nearer, or goes farther
// than the trims do, as it may beside a pole.
Vec2 sharpened(const FaceTrims& trims, const Vec2& uv, const Vec3& point) {
  const SurfaceJet jet = trims.jet(uv);
  const Vec2 step = chart_step(jet, point - jet.point), size = trims.box.high - trims.box.low;
  for (int k = 0; k < 2; ++k)
    if (!(std::abs(step[k]) * trims.scale[k] <= size[k])) return uv;
  const Vec2 next = uv + step;
  return distance(trims.jet(next).point, point) < distance(jet.point, point) ? next : uv;
}

// The point of a curve that only touches there: of a conic its own one, from which what is fitted
// to it in the charts is farther off than two faces are that touch.
//
// b   null if there is none
SurfacePoint touch_of(const IntersectionCurve& curve, double t, const FaceTrims& a,
                      const FaceTrims* b) {
  SurfacePoint touch = point_of(curve, t);
  if (!curve.conic) return touch;
  touch.point = point_at(*curve.conic, t);
  touch.uv_a = sharpened(a, touch.uv_a, touch.point);
  if (b != nullptr) touch.uv_b = sharpened(*b, touch.uv_b, touch.point);
  return touch;
}

double length_of(const IntersectionCurve& curve, const Interval& part) {
  return curve.conic ? arc_length(*curve.conic, part) : length(part);
}

// Both lists are increasing and disjoint. Where one ends as the other begins there is a point.
std::vector<Interval> common(const IntersectionCurve& curve, const std::vector<Interval>& a,
                             const std::vector<Interval>& b) {
  std::vector<Interval> result;
  const Interval domain = curve.curve.domain();
  for (const Interval& x : a)
    for (const Interval& y : b) {
      const Interval both{std::max(x.from, y.from), std::min(x.to, y.to)};
      const bool round_start = curve.closed && std::max(x.to, y.to) == domain.to &&
                               std::min(x.from, y.from) == domain.from;
      if (is_span(both, domain))
        result.push_back(both);
      else if (distance(point_at(curve.curve, both.from), point_at(curve.curve, both.to)) <=
               kSamePoint)
        result.push_back({both.to, both.to});
      else if (round_start)
        result.push_back({domain.from, domain.from});
    }
  return result;
}

// The part of a curve on an interval, its ends named where they are new.
IntersectionCurve part_of(const IntersectionCurve& whole, const Interval& part) {
  IntersectionCurve curve = whole;
  const Interval domain = whole.curve.domain();
  curve.closed = false;
  curve.curve = restricted(whole.curve, part);
  curve.chart_a = restricted(whole.chart_a, part);
  curve.chart_b = restricted(whole.chart_b, part);
  curve.ends = {part.from > domain.from || whole.closed ? CurveEnd::Trim : whole.ends[0],
                part.to < domain.to || whole.closed ? CurveEnd::Trim : whole.ends[1]};
  curve.length = length_of(whole, part);
  curve.samples.clear();
  curve.sample_parameters.clear();
  const auto add = [&](const SurfacePoint& p, double t) {
    curve.samples.push_back(p);
    curve.sample_parameters.push_back(t);
  };
  const double apart = 1e-3 * length(part);
  add(part.from > domain.from ? point_of(whole, part.from) : whole.samples.front(), part.from);
  for (std::size_t i = 0; i < whole.samples.size(); ++i) {
    const double t = whole.sample_parameters[i];
    if (t > part.from + apart && t < part.to - apart) add(whole.samples[i], t);
  }
  add(part.to < domain.to ? point_of(whole, part.to) : whole.samples.back(), part.to);
  return curve;
}

// The same curve with its conic's parameter in the first turn, where it begins.
IntersectionCurve in_first_turn(IntersectionCurve curve) {
  constexpr double kTurn = 2 * std::numbers::pi;
  if (!curve.conic || !curve.conic->is_closed()) return curve;
  const double shift = -kTurn * std::floor(curve.curve.domain().from / kTurn);
  if (shift == 0) return curve;
  for (std::vector<double>* parameters :
       {&curve.curve.knots, &curve.chart_a.knots, &curve.chart_b.knots, &curve.sample_parameters})
    for (double& t : *parameters) t += shift;
  return curve;
}

// A loop's last part and its first one are one curve through the loop's start.
IntersectionCurve appended(IntersectionCurve first, const IntersectionCurve& second) {
  const double shift = first.curve.domain().to - second.curve.domain().from;
  first.curve = joined(first.curve, second.curve);
  first.chart_a = joined(first.chart_a, second.chart_a);
  first.chart_b = joined(first.chart_b, second.chart_b);
  first.length += second.length;
  for (std::size_t i = 1; i < second.samples.size(); ++i) {
    first.samples.push_back(second.samples[i]);
    first.sample_parameters.push_back(second.sample_parameters[i] + shift);
  }
  return first;
}

// One face on which a curve lies, and what of the curve is inside of its trims.
struct Trimming {
  const FaceTrims& trims;
  const Spline2& chart;
  std::vector<Interval> inside;
};

// As `covers_edges` of a part that keeps to wires; corners may lie a period beside it.
bool covers_edges(const Trimming& by, const Interval& part) {
  const Vec2 &scale = by.trims.scale, &period = by.trims.period;
  const auto place = [&](double t, const Vec2& turns) {
    const Vec2 uv = point_at(by.chart, t);
    return Vec2{uv[0] * scale[0] + turns[0] * period[0], uv[1] * scale[1] + turns[1] * period[1]};
  };
  for (const double u : {0.0, 1.0, -1.0})
    for (const double v : {0.0, 1.0, -1.0})
      if (covers_edges(by.trims, place(part.from, {u, v}), place(part.to, {u, v}))) return true;
  return false;
}

// Whether a part of a curve keeps to a wire, and no longer than what touches it may. The trims of
// the other face may have cut it off: what goes on along the wire beyond the part runs along it.
bool only_touches(const IntersectionCurve& whole, const Interval& part, const Trimming& by,
                  double tolerance) {
  const auto on_wire = [&](double t) {
    return border_at(by.trims, point_at(by.chart, t)).has_value();
  };
  const double length = length_of(whole, part), most = wire_touch_length(by.trims, tolerance);
  if (length > most || !on_wire(at(part, 0.5)) || covers_edges(by, part)) return false;
  const auto around = std::ranges::find_if(by.inside, [&](const Interval& inside) {
    return inside.from <= part.from && part.to <= inside.to;
  });
  if (around == by.inside.end() || length == 0) return true;
  const double reach = most / length * (part.to - part.from);
  const Interval run{std::max(around->from, part.from - reach),
                     std::min(around->to, part.to + reach)};
  return length_of(whole, run) <= most ||
         !std::ranges::all_of(kAlong, [&](double t) { return on_wire(at(run, t)); });
}

// Parts too short for an edge become points, and parts that only touch the trims.
void move_short_parts(const IntersectionCurve& whole, const FaceTrims& a, const FaceTrims* b,
                      const std::vector<Trimming>& trimmings, std::vector<Interval>& parts,
                      std::vector<SurfacePoint>& touches) {
  const double tolerance = edge_tolerance(whole.deviation);
  std::erase_if(parts, [&](const Interval& part) {
    const bool touch =
        part != whole.curve.domain() && std::ranges::any_of(trimmings, [&](const Trimming& by) {
          return only_touches(whole, part, by, tolerance);
        });
    if (length_of(whole, part) > 2 * tolerance && !touch) return false;
    touches.push_back(touch_of(whole, at(part, 0.5), a, b));
    return true;
  });
}

// Whether a curve goes past a border that it keeps to all along, and nowhere else out of the trims.
bool is_border_arc(const IntersectionCurve& curve, const FaceTrims& a, const FaceTrims* b,
                   double touching) {
  if (curve.closed || curve.length <= 2 * std::max(edge_tolerance(curve.deviation), touching))
    return false;  // too short to tell along from across
  const bool on_a = keeps_to_border(a, curve.chart_a, touching);
  const bool on_b = b != nullptr && keeps_to_border(*b, curve.chart_b, touching);
  const std::vector<Interval> whole{curve.curve.domain()};
  return (on_a || on_b) && (on_a || clip_to_trims(a, curve.chart_a) == whole) &&
         (on_b || b == nullptr || clip_to_trims(*b, curve.chart_b) == whole);
}

// True if a listed contact in a point holds it, or is no farther than its own size.
bool is_listed(const Vec3& point, const std::vector<Place>& places) {
  constexpr std::array kPoints{PlaceKind::Touch, PlaceKind::Node, PlaceKind::Cusp, PlaceKind::Pole};
  return std::ranges::any_of(places, [&](const Place& place) {
    const double size = distance(place.box_low, place.box_high);
    bool holds = std::ranges::find(kPoints, place.kind) != kPoints.end();
    for (int k = 0; k < 3; ++k)
      holds = holds && place.box_low[k] - size <= point[k] && point[k] <= place.box_high[k] + size;
    return holds;
  });
}

// What the curves of a result end in, a listed contact holds or another touch repeats is no touch
// of its own.
void leave_new_ones(const SurfaceIntersection& found, std::vector<SurfacePoint>& touches) {
  std::vector<Vec3> known;
  for (const IntersectionCurve& curve : found.curves)
    known.insert(known.end(), {curve.samples.front().point, curve.samples.back().point});
  for (const auto* list : {&found.points, &found.nodes})
    for (const SurfacePoint& p : *list) known.push_back(p.point);
  std::erase_if(touches, [&](const SurfacePoint& touch) {
    const bool is_known = is_listed(touch.point, found.places) ||
                          std::any_of(known.begin(), known.end(), [&](const Vec3& p) {
                            return distance(p, touch.point) <= kSamePoint;
                          });
    if (!is_known) known.push_back(touch.point);
    return is_known;
  });
}

// Samples of a curve that lie on both surfaces to rounding. Where trims cut it its ends are on the
// fitted curve, so they count only if there is nothing between them.
std::vector<ChartSample> true_places(const IntersectionCurve& curve, Vec2 SurfacePoint::*uv) {
  std::vector<ChartSample> places;
  for (std::size_t i = 0; i < curve.samples.size(); ++i)
    places.push_back({curve.sample_parameters[i], curve.samples[i].*uv});
  return places.size() > 2 ? std::vector(places.begin() + 1, places.end() - 1) : places;
}

// A contact is known as far as its place goes; what of it may lie inside counts.
bool may_lie_inside(const FaceTrims& trims, const Interval& u, const Interval& v) {
  return trims.natural || part_side(trims, u, v) != PartSide::Outside;
}

Interval widened(const Interval& range, double by) { return {range.from - by, range.to + by}; }

// Whether surfaces that touch in a contact may be within tolerance of each other inside, too.
bool may_reach_inside(const FaceTrims& trims, const Interval& u, const Interval& v,
                      double tolerance) {
  const double reach = wire_touch_length(trims, tolerance);
  return may_lie_inside(trims, widened(u, reach / trims.scale[0]),
                        widened(v, reach / trims.scale[1]));
}

// Contacts that no face reaches are no reason to doubt that these are apart. Any other one that is
// left, which may be of any kind, is.
void trust_far_contacts(bool far, SurfaceIntersection& found) {
  if (!far || !found.places.empty() || found.status != Status::Tolerance) return;
  std::vector<std::string>& reasons = found.certificate.reasons;
  std::erase(reasons, kTouchInPlaces);
  if (reasons.empty()) found.status = Status::Complete;
}

// The place of a contact; just its parameters if it has none.
Place place_of(const SurfacePoint& x, const std::vector<Place>& places) {
  constexpr std::array kWide{PlaceKind::Tangential, PlaceKind::Overlap, PlaceKind::Open};
  const auto& [point, uv_a, uv_b] = x;
  const std::array<double, 4> at{uv_a[0], uv_a[1], uv_b[0], uv_b[1]};
  for (const Place& place : places) {
    bool holds = std::find(kWide.begin(), kWide.end(), place.kind) == kWide.end();
    for (std::size_t k = 0; k < at.size(); ++k)
      holds = holds && place.parameters[k].from <= at[k] && at[k] <= place.parameters[k].to;
    if (holds) return place;
  }
  Place alone;
  for (std::size_t k = 0; k < at.size(); ++k) alone.parameters[k] = {at[k], at[k]};
  return alone;
}

}  // namespace

std::vector<IntersectionCurve> curve_parts(const IntersectionCurve& whole,
                                           const std::vector<Interval>& parts) {
  const Interval domain = whole.curve.domain();
  if (parts.empty()) return {};
  if (parts.size() == 1 && parts[0] == domain) return {whole};
  std::vector<IntersectionCurve> curves;
  for (const Interval& part : parts) curves.push_back(part_of(whole, part));
  // Only where the charts close too: a curve round a period ends on the seam.
  const bool charts_close = whole.closed &&
                            distance(whole.samples.front().uv_a, whole.samples.back().uv_a) == 0 &&
                            distance(whole.samples.front().uv_b, whole.samples.back().uv_b) == 0;
  if (charts_close && curves.size() > 1 && parts.front().from == domain.from &&
      parts.back().to == domain.to) {
    curves.front() = appended(std::move(curves.back()), curves.front());
    curves.pop_back();
  }
  for (IntersectionCurve& curve : curves) curve = in_first_turn(std::move(curve));
  return curves;
}

std::vector<Touch> clip(SurfaceIntersection& found, const FaceTrims& a, const FaceTrims* b,
                        double tolerance, double touching) {
  std::vector<IntersectionCurve> curves, border_arcs;
  std::vector<SurfacePoint> touches;
  const auto add_parts = [&](const IntersectionCurve& curve) {
    std::vector<Trimming> trimmings{{a, curve.chart_a, clip_to_trims(a, curve.chart_a, tolerance)}};
    if (b != nullptr)
      trimmings.push_back({*b, curve.chart_b, clip_to_trims(*b, curve.chart_b, tolerance)});
    std::vector<Interval> parts = trimmings.front().inside;
    if (b != nullptr) parts = common(curve, parts, trimmings.back().inside);
    move_shallow_ends(curve, a, b, std::max(tolerance, kOnWire), parts);
    move_short_parts(curve, a, b, trimmings, parts, touches);
    for (IntersectionCurve& part : curve_parts(curve, parts)) curves.push_back(std::move(part));
  };
  for (const IntersectionCurve& curve : found.curves)
    if (is_border_arc(curve, a, b, touching))
      border_arcs.push_back(curve);
    else
      add_parts(curve);
  const auto is_appended = [&](const IntersectionCurve& arc) {
    return append_border_arc(arc, a, b, curves, touching);
  };
  while (std::erase_if(border_arcs, is_appended) > 0) {  // of several in a row one after the other
  }
  std::ranges::for_each(border_arcs, add_parts);
  found.curves = std::move(curves);
  const auto outside = [&](const SurfacePoint& p) {
    const auto& at = place_of(p, found.places).parameters;
    return !may_lie_inside(a, at[0], at[1]) || (b != nullptr && !may_lie_inside(*b, at[2], at[3]));
  };
  std::erase_if(found.points, outside);
  std::erase_if(found.nodes, outside);
  bool far = !found.places.empty();
  std::erase_if(found.places, [&](const Place& place) {
    const auto& at = place.parameters;
    const bool erased =
        place.kind != PlaceKind::Open &&
        (!may_lie_inside(a, at[0], at[1]) || (b != nullptr && !may_lie_inside(*b, at[2], at[3])));
    far = far && erased &&
          (!may_reach_inside(a, at[0], at[1], touching) ||
           (b != nullptr && !may_reach_inside(*b, at[2], at[3], touching)));
    return erased;
  });
  trust_far_contacts(far, found);
  if (!a.natural || (b != nullptr && !b->natural)) found.overlaps.clear();
  leave_new_ones(found, touches);
  std::vector<Touch> told;
  for (const SurfacePoint& x : touches)
    told.push_back({x, std::max(distance_outwards(a, x.uv_a),
                                b != nullptr ? distance_outwards(*b, x.uv_b) : 0)});
  return told;
}

void add_touches(const std::vector<Touch>& touches, double tolerance, double within,
                 SurfaceIntersection& found) {
  const Vec3 reach{tolerance, tolerance, tolerance};
  bool exact = true;
  for (const auto& [x, gap] : touches) {
    found.points.push_back(x);
    Place place;
    widen(place, x, std::max(tolerance, gap));
    place.kind = PlaceKind::Touch;
    place.gap_low = 0;
    place.box_low = x.point - reach;
    place.box_high = x.point + reach;
    if (gap <= within) {
      place.gap_high = gap;
      identify(found.certificate, gap);
    } else {
      exact = false;
    }
    found.places.push_back(place);
  }
  if (exact) return;
  found.status = weaker(found.status, Status::Tolerance);
  found.certificate.reasons.emplace_back("curves touch the trims of a face in a point");
}

void weaken_along_trims(const FaceTrims& a, const FaceTrims& b, double within,
                        SurfaceIntersection& found) {
  bool exact = true;
  for (const IntersectionCurve& curve : found.curves)
    for (const auto& off :
         {distance_along_wires(a, curve.chart_a, true_places(curve, &SurfacePoint::uv_a)),
          distance_along_wires(b, curve.chart_b, true_places(curve, &SurfacePoint::uv_b))}) {
      if (!off) continue;
      if (*off <= within)
        identify(found.certificate, *off);
      else
        exact = false;
    }
  if (exact) return;
  found.status = weaker(found.status, Status::Tolerance);
  found.certificate.reasons.emplace_back("a curve runs along the trims of a face");
}

void add(Certificate& sum, const Certificate& one) {
  sum.excluded += one.excluded;
  sum.certified += one.certified;
  sum.critical += one.critical;
  sum.cells_bezier += one.cells_bezier;
  sum.cells_monomial += one.cells_monomial;
  sum.depth = std::max(sum.depth, one.depth);
  sum.identified += one.identified;
  sum.identified_within = std::max(sum.identified_within, one.identified_within);
  sum.limited = sum.limited || one.limited;
  sum.rounding_bound = std::max(sum.rounding_bound, one.rounding_bound);
  if (one.least_angle > 0)
    sum.least_angle =
        sum.least_angle > 0 ? std::min(sum.least_angle, one.least_angle) : one.least_angle;
  for (const std::string& reason : one.reasons)
    if (std::find(sum.reasons.begin(), sum.reasons.end(), reason) == sum.reasons.end())
      sum.reasons.push_back(reason);
}

}  // namespace blossom
