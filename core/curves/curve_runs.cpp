// SPDX-License-Identifier: LGPL-2.1-or-later
// Pairs of pieces that stay within tolerance of each other, as runs, points of contact, and cusps.
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/base/disjoint_sets.h"
#include "core/base/unbounded.h"
#include "core/curves/contact_length.h"
#include "core/curves/curve_assembly.h"
#include "core/curves/shared_curve.h"
#include "core/math/functions/golden_section.h"
#include "core/math/interval.h"

namespace blossom {
namespace {

constexpr double kReachStep = 0.125;  // of a run
constexpr double kNearest = 1e-12;    // of a run: where curves are nearest to each other
constexpr int kDeepest = 10;          // halvings of a piece between knots, to prove how near it is
constexpr double kAtKnot = 1e-12;     // of a span
constexpr double kMinEven = 0.1;      // of a piece of b: as near an end its middle's foot may be

struct SpanPart {
  const RationalBezierCurve* curve;
  Interval local;  // may run backwards
};

// The part of a curve between two parameters; nothing if a knot is between them.
std::optional<SpanPart> between_knots(const CurveTree& tree, const Interval& range) {
  const SpanPoint middle = tree.place(at(range, 0.5));
  const CurveSpan& span = tree.curve().spans[static_cast<std::size_t>(middle.span)];
  const double slack = kAtKnot * length(span.place);
  const auto local = [&](double parameter) {
    return local_parameter(span.law, span.place,
                           std::clamp(parameter, span.place.from, span.place.to));
  };
  const Interval ends = increasing(range);
  if (ends.from < span.place.from - slack || ends.to > span.place.to + slack) return std::nullopt;
  return SpanPart{&span.curve, {local(range.from), local(range.to)}};
}

}  // namespace

// Pieces that follow each other on both curves, as runs. Where spans of both curves end beside each
// other the pieces do too, at each other's feet: less than the tolerance may be missing between.
void CurveAssembly::add_contacts(std::vector<CurveContact> contacts) {
  std::sort(contacts.begin(), contacts.end(),
            [](const CurveContact& x, const CurveContact& y) { return x.a.from < y.a.from; });
  DisjointSets sets(contacts.size());
  const auto follow = [&](const CurveTree& tree, const Interval& p, const Interval& q) {
    if (overlap(p, q)) return true;
    return p.to < q.from ? tree.stays_near(p.to, q.from, tolerance_)
                         : tree.stays_near(q.to, p.from, tolerance_);
  };
  std::vector<std::size_t> active;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    std::erase_if(active, [&](std::size_t k) { return !follow(a_, contacts[k].a, contacts[i].a); });
    for (const std::size_t k : active)
      if (follow(b_, contacts[k].b, contacts[i].b)) sets.join(i, k);
    active.push_back(i);
  }
  std::vector<CurveContact> runs(contacts.size());
  std::vector<bool> used(contacts.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const std::size_t r = sets.find(i);
    CurveContact& run = runs[r];
    if (!used[r]) {
      run = contacts[i];
      used[r] = true;
      continue;
    }
    run.a = {std::min(run.a.from, contacts[i].a.from), std::max(run.a.to, contacts[i].a.to)};
    run.b = {std::min(run.b.from, contacts[i].b.from), std::max(run.b.to, contacts[i].b.to)};
    run.neighbours = run.neighbours || contacts[i].neighbours;
  }
  for (std::size_t r = 0; r < runs.size(); ++r)
    if (used[r]) runs[r].neighbours ? add_cusp(runs[r]) : add_run(runs[r]);
}

// The ends of a run: where one of the curves ends, its foot on the other. A cell of b may reach to
// an end that is far from a.
CurveOverlap CurveAssembly::trimmed(const CurveContact& run) const {
  CurveOverlap result{run.a, run.reversed ? Interval{run.b.to, run.b.from} : run.b, 0, false};
  const Interval on_a = a_.curve().domain(), on_b = b_.curve().domain();
  const auto settle = [&](double& at_a, double& at_b) {
    if ((at_b == on_b.from || at_b == on_b.to) && at_a != on_a.from && at_a != on_a.to) {
      const Vec3 end = b_.jet(b_.place(at_b)).point;
      const SpanPoint foot = foot_along(a_, end, at_a);
      if (distance(a_.jet(foot).point, end) <= 2 * tolerance_) {
        at_a = a_.parameter(foot);
        return;
      }
    }
    at_b = b_.parameter(foot_along(b_, a_.jet(a_.place(at_a)).point, at_b));
  };
  settle(result.a.from, result.b.from);
  settle(result.a.to, result.b.to);
  return result;
}

// Feet along a run from its start, 0, to its end, 1, and beyond.
CurveFoot CurveAssembly::foot_of(const CurveOverlap& run, double part) const {
  CurveFoot foot;
  foot.a = a_.place(at(run.a, part));
  foot.jet_a = a_.jet(foot.a);
  foot.b = foot_along(b_, foot.jet_a.point, at(run.b, part));
  foot.jet_b = b_.jet(foot.b);
  return foot;
}

// How far the curves stay within tolerance beyond the ends of a run, as parts of it: what was found
// to be a crossing or proven apart there belongs to the contact all the same.
Interval CurveAssembly::reach_of(const CurveOverlap& run) const {
  const Interval domain = a_.curve().domain();
  const auto reached = [&](double end, double limit, double step) {
    for (; end != limit; step *= 1.5) {
      const double next = step > 0 ? std::min(end + step, limit) : std::max(end + step, limit);
      if (norm(foot_of(run, next).gap()) > tolerance_) break;
      end = next;
    }
    return end;
  };
  const auto part_at = [&](double parameter) { return (parameter - run.a.from) / length(run.a); };
  return {reached(0, std::min(0.0, part_at(domain.from)), -kReachStep),
          reached(1, std::max(1.0, part_at(domain.to)), kReachStep)};
}

// An end of one of the curves is the place, or cannot be told from it.
bool CurveAssembly::is_at_end(const CurveFoot& foot) const {
  const auto near_end = [&](const CurveTree& tree, const SpanPoint& place) {
    const Interval domain = tree.curve().domain();
    const double parameter = tree.parameter(place);
    return tree.stays_near(parameter, domain.from, tolerance_) ||
           tree.stays_near(parameter, domain.to, tolerance_);
  };
  return near_end(a_, foot.a) || near_end(b_, foot.b);
}

std::array<double, CurveAssembly::kSamples> CurveAssembly::gaps_in(const CurveOverlap& run,
                                                                   const Interval& reach) const {
  std::array<double, kSamples> gaps{};
  for (std::size_t i = 0; i < kSamples; ++i)
    gaps[i] = norm(foot_of(run, at(reach, static_cast<double>(i) / (kSamples - 1))).gap());
  return gaps;
}

// The curves are one along most of a contact, or side by side.
bool CurveAssembly::is_common(const CurveOverlap& run) const {
  return is_common_run(gaps_in(run, reach_of(run)), tolerance_, margin_);
}

// Places on both curves along a run, from end to end, between which neither has a knot: knots with
// their feet, or with the other curve's knot that cannot be told from that.
std::vector<std::array<double, 2>> CurveAssembly::stops_along(const CurveOverlap& run) const {
  std::vector<std::array<double, 2>> stops{{run.a.from, run.b.from}, {run.a.to, run.b.to}};
  std::vector<double> knots;
  const Interval on_b = increasing(run.b);
  for (const CurveSpan& span : b_.curve().spans)
    if (const double t = span.place.from; on_b.from < t && t < on_b.to) knots.push_back(t);
  for (const CurveSpan& span : a_.curve().spans) {
    const double s = span.place.from;
    if (s <= run.a.from || s >= run.a.to) continue;
    const double foot = b_.parameter(foot_of(run, (s - run.a.from) / length(run.a)).b);
    const auto same =
        std::ranges::find_if(knots, [&](double t) { return b_.stays_near(foot, t, tolerance_); });
    stops.push_back({s, same == knots.end() ? foot : *same});
    if (same != knots.end()) knots.erase(same);
  }
  for (const double t : knots) {
    const double guess = at(run.a, (t - run.b.from) / length(run.b));
    stops.push_back({a_.parameter(foot_along(a_, b_.jet(b_.place(t)).point, guess)), t});
  }
  std::ranges::sort(stops);
  return stops;
}

// Whether the two parts of a run are proven to be within a distance of each other, which samples do
// not tell. Pieces between knots are halved at feet until they are so at parameters that agree at
// both ends and in the middle.
bool CurveAssembly::is_near(const CurveOverlap& run, double most) const {
  const std::vector<std::array<double, 2>> stops = stops_along(run);
  for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
    const auto& [s, t] = stops[i];
    const auto& [next_s, next_t] = stops[i + 1];
    if (!is_near({s, next_s}, {t, next_t}, most, 0)) return false;
  }
  return true;
}

bool CurveAssembly::is_near(const Interval& on_a, const Interval& on_b, double most,
                            int depth) const {
  const double s = at(on_a, 0.5);
  const SpanPoint foot = foot_along(b_, a_.jet(a_.place(s)).point, at(on_b, 0.5));
  const auto part_a = between_knots(a_, on_a), part_b = between_knots(b_, on_b);
  if (part_a && part_b) {
    const double along = (foot.t - part_b->local.from) / length(part_b->local);
    const bool is_even = along > kMinEven && along < 1 - kMinEven;
    const LinearRational map{part_a->local, part_b->local, is_even ? (1 - along) / along : 1};
    if (distance_bound(*part_a->curve, *part_b->curve, map) <= most) return true;
  }
  const double t = b_.parameter(foot);
  return depth < kDeepest && is_near({on_a.from, s}, {on_b.from, t}, most, depth + 1) &&
         is_near({s, on_a.to}, {t, on_b.to}, most, depth + 1);
}

// All of a contact, if it goes on from end to end of one of the curves: that is a run however the
// gap varies, since curves with but points of contact would part before.
std::optional<CurveOverlap> CurveAssembly::end_to_end(const CurveOverlap& run) const {
  const Interval reach = reach_of(run);
  const CurveFoot first = foot_of(run, reach.from), last = foot_of(run, reach.to);
  if (!is_at_end(first) || !is_at_end(last)) return std::nullopt;
  const CurveOverlap whole{{a_.parameter(first.a), a_.parameter(last.a)},
                           {b_.parameter(first.b), b_.parameter(last.b)},
                           std::max(run.gap_high, std::ranges::max(gaps_in(run, reach)) + margin_),
                           false};
  if (!is_near(whole, tolerance_ + margin_)) return std::nullopt;
  return whole;
}

bool CurveAssembly::is_part_of_one(const CurveOverlap& run,
                                   const std::vector<CurveOverlap>& of) const {
  return std::ranges::any_of(of, [&](const CurveOverlap& whole) {
    return std::ranges::all_of(std::array{0.0, 0.5, 1.0}, [&](double part) {
      return is_on(whole, candidate(foot_of(run, part)));
    });
  });
}

// Parts of one run from end to end, and the points in it, as that run: proven parts have others
// between them that are none, and too short to be told from points.
void CurveAssembly::join_overlaps() {
  if (itself_) return;
  std::vector<CurveOverlap> wholes;
  const auto on_whole = [&](const Candidate& point) {
    return std::ranges::any_of(wholes, [&](const CurveOverlap& run) { return is_on(run, point); });
  };
  const auto is_inside = [&](const CurveOverlap& run) { return is_part_of_one(run, wholes); };
  for (const CurveOverlap& part : overlaps_) {
    if ((is_at_end(foot_of(part, 0)) && is_at_end(foot_of(part, 1))) || is_inside(part)) continue;
    if (const auto whole = end_to_end(part)) wholes.push_back(*whole);
  }
  if (wholes.empty()) return;
  std::erase_if(overlaps_, is_inside);
  std::erase_if(points_, on_whole);
  overlaps_.insert(overlaps_.end(), wholes.begin(), wholes.end());
}

// Where the curves are nearest to each other along a run, near a sample of it.
CurveAssembly::Candidate CurveAssembly::nearest_in(const CurveOverlap& run, double sample) const {
  constexpr double kStep = 1.0 / (kSamples - 1);
  const Interval around{std::max(0.0, sample - kStep), std::min(1.0, sample + kStep)};
  // Where both gaps are roundings, so is all between.
  const auto is_nearest = [&](const Interval& left, const LeastBracket& gaps) {
    return length(left) <= kNearest || std::max(gaps.at_from, gaps.at_to) <= margin_;
  };
  const LeastBracket found = least_bracket(
      [&](double part) { return norm(foot_of(run, part).gap()); }, around, is_nearest);
  return candidate(foot_of(run, at(found.places, 0.5)));
}

void CurveAssembly::add_run(const CurveContact& contact) {
  CurveOverlap run = trimmed(contact);
  double run_length = 0, best = 0, least = kInfinity;
  Vec3 last = a_.jet(a_.place(run.a.from)).point;
  for (int i = 0; i < kSamples; ++i) {
    const double part = static_cast<double>(i) / (kSamples - 1);
    const CurveFoot foot = foot_of(run, part);
    const double gap = norm(foot.gap());
    if (gap < least) best = part;
    least = std::min(least, gap);
    run_length += distance(last, foot.jet_a.point);
    last = foot.jet_a.point;
    run.gap_high = std::max(run.gap_high, gap + margin_);
  }
  // Pieces of one line that follow each other keep to one strip, but meet in an end at most.
  const double most = 2 * (tolerance_ + margin_);
  const bool strays = run.gap_high > most;
  const bool is_run = !strays && run_length > touch_length_ && (is_common(run) || end_to_end(run));
  if (is_run && is_near(run, most)) {
    if (is_part_of_one(run, overlaps_)) return;
    overlaps_.push_back(run);
    std::erase_if(points_, [&](const Candidate& point) { return on_overlap(point); });
    return;
  }
  Candidate touch = nearest_in(run, best);
  if (itself_ && a_.stays_near(touch.at_a, touch.at_b, tolerance_)) return add_cusp(contact);
  if (touch.gap.low > tolerance_ || on_overlap(touch) || beside_overlap(touch)) return;
  touch.touch = true;
  if (!strays) {
    touch.half_length = 0.5 * run_length;
    touch.box_a = run.a;
    touch.box_b = increasing(run.b);
  }
  const Vec3 first = foot_of(run, 0).gap(), final = foot_of(run, 1).gap();
  touch.crosses = a_.dimension() == 2 && dot(first, final) < 0;
  for (Candidate& known : points_) {
    if (!same(known, touch) && !are_one(known, touch.at_a, touch.at_b)) continue;
    // A proven point says nothing about the rest of a run that goes on beyond it.
    const bool all = a_.stays_near(known.at_a, run.a.from, tolerance_) &&
                     a_.stays_near(known.at_a, run.a.to, tolerance_);
    if (known.proven && !all) places_.push_back(place_of(touch));
    if (!known.proven && touch.gap.high < known.gap.high) known = touch;
    return;
  }
  points_.push_back(touch);
}

void CurveAssembly::add_cusp(const CurveContact& run) {
  const double parameter = 0.5 * (std::max(run.a.from, run.b.from) + std::min(run.a.to, run.b.to));
  const Vec3 point = a_.jet(a_.place(parameter)).point;
  CurvePlace place{PlaceKind::Cusp, point, point, 0, 0, run.a, run.b};
  for (const Interval& side : {run.a, run.b})
    for (int i = 0; i < kSamples; ++i) {
      const double part = static_cast<double>(i) / (kSamples - 1);
      const Vec3 p = a_.jet(a_.place(at(side, part))).point;
      for (int k = 0; k < a_.dimension(); ++k) {
        place.box_low[k] = std::min(place.box_low[k], p[k] - tolerance_);
        place.box_high[k] = std::max(place.box_high[k], p[k] + tolerance_);
      }
    }
  place.gap_high = 2 * tolerance_;
  places_.push_back(place);
}

}  // namespace blossom
