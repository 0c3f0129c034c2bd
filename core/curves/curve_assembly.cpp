// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/curves/curve_assembly.h"

#include <algorithm>
#include <cmath>

#include "core/base/unbounded.h"
#include "core/curves/contact_length.h"
#include "core/curves/overlap_place.h"
#include "core/math/interval.h"

namespace blossom {
namespace {

constexpr double kSmooth = 1e-6;         // sine of the angle between spans that make no kink
constexpr double kTransversal = 1e-9;    // sine above which a point between spans is a crossing
constexpr int kBetween = 4;              // samples between two contacts that may be one
constexpr double kSameParameter = 1e-9;  // of the domain, between runs that follow each other

// A parameter on the shorter way between two, perhaps over the seam of a closed curve.
double between(const CurveTree& tree, double from, double to, double part) {
  const Interval domain = tree.curve().domain();
  const double period = length(domain);
  if (tree.closed() && std::abs(to - from) > 0.5 * period) to += to < from ? period : -period;
  const double result = at({from, to}, part);
  if (result > domain.to && tree.closed()) return result - period;
  return result < domain.from && tree.closed() ? result + period : result;
}

}  // namespace

CurveAssembly::CurveAssembly(CurveTree& a, CurveTree& b, double tolerance)
    : a_(a),
      b_(b),
      tolerance_(tolerance),
      itself_(&a == &b),
      margin_(2 * (a.evaluation_margin() + b.evaluation_margin())),
      touch_length_(curve_touch_length(tolerance, std::min(a.size(), b.size()))) {}

CurveAssembly::Candidate CurveAssembly::candidate(const SpanPoint& a, const SpanPoint& b) const {
  return candidate(CurveFoot{a, b, a_.jet(a), b_.jet(b)});
}

CurveAssembly::Candidate CurveAssembly::candidate(const CurveFoot& foot) const {
  Candidate result;
  result.a = foot.a;
  result.b = foot.b;
  result.at_a = a_.parameter(foot.a);
  result.at_b = b_.parameter(foot.b);
  result.box_a = {result.at_a, result.at_a};
  result.box_b = {result.at_b, result.at_b};
  result.foot = foot;
  const double gap = norm(result.foot.gap());
  result.gap = {std::max(0.0, gap - margin_), gap + margin_};
  result.sine = norm(cross(unit(result.foot.jet_a.first), unit(result.foot.jet_b.first)));
  return result;
}

void CurveAssembly::find_ends() {
  add_ends(true);
  if (!itself_) add_ends(false);
}

void CurveAssembly::add_ends(bool of_a) {
  CurveTree& own = of_a ? a_ : b_;
  CurveTree& other = of_a ? b_ : a_;
  for (int span = 0; span < own.spans(); ++span)
    for (const double t : {0.0, 1.0}) {
      if (t == 1 && span + 1 < own.spans()) continue;  // the next span's first end
      const SpanPoint end{span, t};
      const Vec3 point = own.end_point(end);
      for (SpanPoint foot : feet_near(other, point, tolerance_)) {
        if (other.jet({foot.span, std::round(foot.t)}).point == point) foot.t = std::round(foot.t);
        const Candidate found = of_a ? candidate(end, foot) : candidate(foot, end);
        if (!itself_ || !a_.stays_near(found.at_a, found.at_b, tolerance_)) ends_.push_back(found);
      }
    }
}

std::vector<SharedSpans> CurveAssembly::shared_parts() const {
  std::vector<SharedSpans> parts;
  if (itself_) return parts;
  const auto try_pair = [&](const SpanPoint& a, const SpanPoint& b) {
    for (const SharedSpans& known : parts)
      if (known.span_a == a.span && known.span_b == b.span) return;
    const auto& on_a = a_.curve().spans[static_cast<std::size_t>(a.span)].curve;
    const auto& on_b = b_.curve().spans[static_cast<std::size_t>(b.span)].curve;
    if (const auto shared = shared_curve(on_a, on_b, a.t, b.t, tolerance_))
      parts.push_back({a.span, b.span, *shared});
  };
  for (const Candidate& end : ends_) {
    const SpanPoint beyond_a = end.a.t == 0 || end.a.t == 1 ? a_.across_join(end.a) : end.a;
    const SpanPoint beyond_b = end.b.t == 0 || end.b.t == 1 ? b_.across_join(end.b) : end.b;
    for (const SpanPoint& a : {end.a, beyond_a})
      for (const SpanPoint& b : {end.b, beyond_b}) try_pair(a, b);
  }
  return parts;
}

// The curves turn into each other here: their first derivatives have one direction on both sides.
bool CurveAssembly::is_kink(const CurveTree& tree, const SpanPoint& at) const {
  if (at.t != 0 && at.t != 1) return false;
  const SpanPoint other = tree.across_join(at);
  if (other.span == at.span && other.t == at.t) return true;
  const Vec3 p = unit(tree.jet(at).first), q = unit(tree.jet(other).first);
  return !(norm(cross(p, q)) < kSmooth && dot(p, q) > 0);
}

// Source: Kantorovich's theorem, in parameters scaled to lengths. With the sine of the angle, the
// inverse of the Jacobian is at most sqrt(2) / sine; curvatures bound its change.
void CurveAssembly::prove(Candidate& point) const {
  const double speed_a = norm(point.foot.jet_a.first), speed_b = norm(point.foot.jet_b.first);
  const auto at_end = [](const SpanPoint& at) { return at.t == 0 || at.t == 1; };
  if (at_end(point.a) && at_end(point.b) && point.foot.gap() == Vec3{}) {
    point.proven = true;
    return;
  }
  if (!(point.sine > 0) || point.gap.low > margin_) return;
  const double inverse = std::sqrt(2.0) / point.sine;
  const double step = inverse * (point.gap.high + margin_);
  const double reach_a = 2 * step / speed_a, reach_b = 2 * step / speed_b;
  const auto is_regular = [&] {
    const double bend = a_.bend_near(point.a, reach_a) / (speed_a * speed_a) +
                        b_.bend_near(point.b, reach_b) / (speed_b * speed_b);
    return inverse * bend * step <= 0.25;
  };
  if (!is_regular()) {  // over smaller cells, perhaps
    a_.split_near(point.a, reach_a);
    b_.split_near(point.b, reach_b);
    if (!is_regular()) return;
  }
  const auto box = [](const CurveTree& tree, const SpanPoint& at, double reach) {
    return Interval{tree.parameter({at.span, std::max(0.0, at.t - reach)}),
                    tree.parameter({at.span, std::min(1.0, at.t + reach)})};
  };
  point.box_a = box(a_, point.a, reach_a);
  point.box_b = box(b_, point.b, reach_b);
  const auto interior = [](double t, double reach) { return t - reach > 0 && t + reach < 1; };
  const bool inside = interior(point.a.t, reach_a) && interior(point.b.t, reach_b);
  point.proven = inside || prove_at_border(point, reach_a, reach_b);
}

// Where spans join, curves cross if each of the two directions passes the other curve the same way.
bool CurveAssembly::prove_at_border(Candidate& point, double reach_a, double reach_b) const {
  const auto snapped = [](SpanPoint at, double reach) {
    if (at.t - reach <= 0) at.t = 0;
    if (at.t + reach >= 1) at.t = 1;
    return at;
  };
  const SpanPoint a = snapped(point.a, reach_a), b = snapped(point.b, reach_b);
  const auto sides = [](const CurveTree& tree, const SpanPoint& at) {
    const bool join = at.t == 0 || at.t == 1;
    return std::array<Vec3, 2>{unit(tree.jet(at).first),
                               unit(tree.jet(join ? tree.across_join(at) : at).first)};
  };
  const auto is_end = [](const CurveTree& tree, const SpanPoint& at) {
    return (at.t == 0 || at.t == 1) && tree.is_free_end(at);
  };
  if (is_end(a_, a) || is_end(b_, b)) return false;
  const Vec3 first = cross(sides(a_, a)[0], sides(b_, b)[0]);
  for (const Vec3& p : sides(a_, a))
    for (const Vec3& q : sides(b_, b)) {
      const Vec3 turn = cross(p, q);
      if (!(norm(turn) > kTransversal && dot(turn, first) > 0)) return false;
    }
  return true;
}

bool CurveAssembly::same(const Candidate& p, const Candidate& q) const {
  const double farthest = 3 * tolerance_ + margin_;  // of what may be near
  if (distance(p.foot.jet_a.point, q.foot.jet_a.point) > farthest) return false;
  return a_.stays_near(p.at_a, q.at_a, tolerance_) && b_.stays_near(p.at_b, q.at_b, tolerance_);
}

// The curves stay within tolerance of each other from a contact to another pair of parameters.
bool CurveAssembly::connected(const Candidate& p, double at_a, double at_b) const {
  for (int i = 1; i <= kBetween; ++i) {
    const double part = static_cast<double>(i) / kBetween;
    const Vec3 point = a_.jet(a_.place(between(a_, p.at_a, at_a, part))).point;
    const SpanPoint foot = foot_along(b_, point, between(b_, p.at_b, at_b, part));
    if (!(distance(point, b_.jet(foot).point) <= 2 * tolerance_)) return false;
  }
  return true;
}

// The same for two contacts no farther from each other than contacts of order four are long, as far
// as a few points between them tell.
bool CurveAssembly::are_one(const Candidate& p, double at_a, double at_b) const {
  const double size = std::min(a_.size(), b_.size());
  const double longest = size * std::pow(tolerance_ / size, 0.2);
  return distance(p.foot.jet_a.point, a_.jet(a_.place(at_a)).point) <= longest &&
         connected(p, at_a, at_b);
}

// The same point once. Two proven points closer than the tolerance are one contact, and so are two
// others between which the curves stay within it.
void CurveAssembly::add(Candidate point) {
  for (Candidate& known : points_) {
    const bool contact = !known.proven && !point.proven;
    if (!same(known, point) && !(contact && are_one(known, point.at_a, point.at_b))) continue;
    const bool distinct = known.proven && point.proven &&
                          !(overlap(known.box_a, point.box_a) && overlap(known.box_b, point.box_b));
    if (distinct && !(a_.closed() || b_.closed())) {
      known.proven = false;
      known.touch = true;
    } else if ((point.proven && !known.proven && !known.touch) ||
               (contact && point.gap.high < known.gap.high)) {
      known = point;
    }
    return;
  }
  points_.push_back(point);
}

bool CurveAssembly::is_on(const CurveOverlap& run, const Candidate& point) const {
  if (a_.stays_near(point.at_a, run.a.from, tolerance_) &&
      b_.stays_near(point.at_b, run.b.from, tolerance_))
    return true;
  if (a_.stays_near(point.at_a, run.a.to, tolerance_) &&
      b_.stays_near(point.at_b, run.b.to, tolerance_))
    return true;
  const Interval on_b = increasing(run.b);
  if (point.at_a < run.a.from || point.at_a > run.a.to || point.at_b < on_b.from ||
      point.at_b > on_b.to)
    return false;
  const double part = (point.at_a - run.a.from) / length(run.a);
  const SpanPoint foot = foot_along(b_, point.foot.jet_a.point, at(run.b, part));
  return b_.stays_near(b_.parameter(foot), point.at_b, tolerance_);
}

bool CurveAssembly::on_overlap(const Candidate& point) const {
  return std::ranges::any_of(overlaps_, [&](const CurveOverlap& run) { return is_on(run, point); });
}

// Whether a contact goes on into a run, whose ends need not be the ends of the contact.
bool CurveAssembly::beside_overlap(const Candidate& point) const {
  return std::ranges::any_of(overlaps_, [&](const CurveOverlap& run) {
    return are_one(point, run.a.from, run.b.from) || are_one(point, run.a.to, run.b.to);
  });
}

void CurveAssembly::add_overlaps(const std::vector<SharedSpans>& shared) {
  for (const SharedSpans& part : shared) {
    const LinearRational& map = part.shared.map;
    overlaps_.push_back(
        {{a_.parameter({part.span_a, map.from.from}), a_.parameter({part.span_a, map.from.to})},
         {b_.parameter({part.span_b, map.to.from}), b_.parameter({part.span_b, map.to.to})},
         part.shared.gap,
         true});
  }
  std::sort(overlaps_.begin(), overlaps_.end(),
            [](const CurveOverlap& x, const CurveOverlap& y) { return x.a.from < y.a.from; });
  std::vector<CurveOverlap> joined;
  const double slack_a = kSameParameter * length(a_.curve().domain());
  const double slack_b = kSameParameter * length(b_.curve().domain());
  for (const CurveOverlap& run : overlaps_) {
    const auto before = std::find_if(joined.begin(), joined.end(), [&](const CurveOverlap& known) {
      return std::abs(known.a.to - run.a.from) <= slack_a &&
             std::abs(known.b.to - run.b.from) <= slack_b;
    });
    if (before == joined.end()) {
      joined.push_back(run);
      continue;
    }
    before->a.to = run.a.to;
    before->b.to = run.b.to;
    before->gap_high = std::max(before->gap_high, run.gap_high);
  }
  overlaps_ = std::move(joined);
}

CurvePlace CurveAssembly::place_of(const Candidate& point) const {
  const Vec3 p = point.foot.jet_a.point, q = point.foot.jet_b.point;
  const Vec3 along = unit(point.foot.jet_a.first) * point.half_length;
  CurvePlace place{point.crosses ? PlaceKind::Tangential : PlaceKind::Touch,
                   p,
                   p,
                   point.gap.low,
                   point.gap.high,
                   point.box_a,
                   point.box_b};
  for (int k = 0; k < a_.dimension(); ++k) {
    const double reach = std::abs(along[k]) + point.gap.high;
    place.box_low[k] = std::min(p[k], q[k]) - reach;
    place.box_high[k] = std::max(p[k], q[k]) + reach;
  }
  return place;
}

void CurveAssembly::write(CurveIntersection& result) const {
  double least = kInfinity;
  for (const Candidate& point : points_) {
    CurvePoint written{point.foot.jet_a.point, point.at_a,  point.at_b, point.touch,
                       point.proven,           point.box_a, point.box_b};
    written.tangential = point.sine <= kTransversal || (point.touch && point.sine < kSmooth);
    result.points.push_back(written);
    const double cosine = std::abs(dot(unit(point.foot.jet_a.first), unit(point.foot.jet_b.first)));
    if (point.proven) least = std::min(least, std::atan2(point.sine, cosine));
    if (!point.proven) result.places.push_back(place_of(point));
  }
  if (std::isfinite(least)) result.certificate.least_angle = least;
  std::sort(result.points.begin(), result.points.end(),
            [](const CurvePoint& x, const CurvePoint& y) { return x.a < y.a; });
  result.places.insert(result.places.end(), places_.begin(), places_.end());
  result.overlaps = overlaps_;
  for (const CurveOverlap& run : overlaps_) {
    CurvePlace place = overlap_place(a_, run.a, run.gap_high);
    place.b = increasing(run.b);
    result.places.push_back(place);
  }
}

CurveIntersection CurveAssembly::finish(const std::vector<SharedSpans>& shared,
                                        const CurveFindings& found) {
  add_overlaps(shared);
  for (const ValleyPoint& known : found.points) {
    Candidate point = candidate(known.foot);
    point.touch = known.touch;
    point.gap = known.gap;
    point.half_length = known.half_length;
    if (!point.touch) prove(point);
    if (!on_overlap(point)) add(point);
  }
  add_contacts(found.contacts);
  join_overlaps();
  for (Candidate end : ends_) {
    const bool corner = is_kink(a_, end.a) || is_kink(b_, end.b);
    if (!corner || on_overlap(end)) continue;
    const bool known = std::any_of(points_.begin(), points_.end(), [&](const Candidate& point) {
      return same(point, end) || connected(point, end.at_a, end.at_b);
    });
    if (known) continue;
    prove(end);
    points_.push_back(end);
  }
  CurveIntersection result;
  write(result);
  return result;
}

}  // namespace blossom
