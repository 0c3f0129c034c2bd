// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/curves/curve_search.h"

#include <algorithm>
#include <cmath>

#include "core/base/work_limit.h"
#include "core/curves/limits.h"
#include "core/math/interval.h"

namespace blossom {
namespace {

constexpr int kFirstRoom = 16;  // pairs, or cells, that wait: mostly enough
// Contacts longer than this part of the curves are not looked for as valleys.
constexpr double kLongestValley = 0.03;
constexpr double kStraight = 1e-3;      // a sine below which a cell's length alone counts
constexpr double kOneComponent = 0.9;   // cosine of a cone in which one place has a given component
constexpr double kWorthClipping = 0.6;  // of a cell; clipping makes one pair, halving two
constexpr double kAlike = 16;           // lengths of cells that may be one contact
constexpr int kAxisSteps = 60;
constexpr int kEndFootSteps = 3;
constexpr int kAlongSteps = 8;
constexpr double kParameterRounding = 0x1p-51;  // a step of a parameter that is rounding

double box_distance(const CurveCell& cell, const Vec3& point, int dimension) {
  double farthest = 0;
  for (int k = 0; k < dimension; ++k)
    farthest = std::max({farthest, cell.low[k] - point[k], point[k] - cell.high[k]});
  return farthest;
}

// The cell whose points and directions spread more; a straight one need not be halved to be told
// from a bent one.
bool first_is_larger(const CurvePair& pair) {
  const auto spread = [](const CurveCell& cell) {
    return cell.extent * (kStraight + std::sqrt(std::max(0.0, 1 - cell.cosine * cell.cosine)));
  };
  if (!(pair.a.cosine > 0 && pair.b.cosine > 0)) return pair.a.extent >= pair.b.extent;
  return spread(pair.a) >= spread(pair.b);
}

double sine_between(const CurveFoot& foot) {
  const Vec3 &p = foot.jet_a.first, &q = foot.jet_b.first;
  return norm(cross(p, q)) / (norm(p) * norm(q));
}

// Both cones within less than a right angle of one direction: all tangents of the two pieces have
// a positive component along it, so one curve that runs through both does not meet itself.
bool turns_little(const CurveCell& a, const CurveCell& b, double sign) {
  constexpr double kRoundingOfAngle = 1e-9;  // radians, many times that of unit vectors
  const Vec3 middle = unit(a.axis + b.axis * sign);
  const auto holds = [&](const CurveCell& cell, double s) {
    const double c = s * dot(middle, cell.axis);
    if (!(c > 0 && cell.cosine > 0)) return false;
    const double sines = std::sqrt(std::max(0.0, (1 - c * c) * (1 - cell.cosine * cell.cosine)));
    return c * cell.cosine > sines + kRoundingOfAngle;
  };
  return holds(a, 1) && holds(b, sign);
}

Interval image(const LinearRational& map, const Interval& part) {
  const double p = map(part.from), q = map(part.to);
  return {std::min(p, q), std::max(p, q)};
}

// The place of a cell with narrow cone whose point has the component of `point` along the axis,
// in which the curve only grows; then the foot near it.
SpanPoint foot_in(const CurveTree& tree, const CurveCell& cell, const Vec3& point) {
  Interval bracket = cell.local;
  double t = at(bracket, 0.5);
  for (int k = 0; k < kAxisSteps; ++k) {
    const CurveJet jet = tree.jet({cell.span, t});
    const double rest = dot(cell.axis, point - jet.point);
    (rest > 0 ? bracket.from : bracket.to) = t;
    double next = t + rest / dot(cell.axis, jet.first);
    if (!(next >= bracket.from && next <= bracket.to)) next = at(bracket, 0.5);
    if (std::abs(next - t) <= kParameterRounding) break;
    t = next;
  }
  for (int k = 0; k < kEndFootSteps; ++k) {
    const CurveJet jet = tree.jet({cell.span, t});
    const double step = dot(jet.first, point - jet.point) / dot(jet.first, jet.first);
    if (std::isfinite(step)) t = std::clamp(t + step, cell.local.from, cell.local.to);
  }
  return {cell.span, t};
}

}  // namespace

CurveFindings CurveSearch::run(const std::vector<SharedSpans>& shared) {
  shared_ = &shared;
  longest_valley_ = kLongestValley * std::min(a_.size(), b_.size());
  add_spans();
  const WorkLimit limit(options_);
  for (long count = 1; !pairs_.empty(); ++count) {
    if (count % SharedWork::kAskEvery == 0) found_.stopped = limit.reached();
    if (count > options_.budget) found_.stopped = "the budget is spent";
    if (found_.stopped) break;
    const auto [index_a, index_b] = pairs_.back();
    pairs_.pop_back();
    examine(index_a, index_b);
  }
  for (const auto& [index_a, index_b] : pairs_)
    add_contact({a_, a_[index_a], b_, b_[index_b]}, found_.open);
  return std::move(found_);
}

void CurveSearch::add_spans() {
  pairs_.reserve(kFirstRoom);
  for (int i = 0; i < a_.spans(); ++i)
    for (int j = itself_ ? i : 0; j < b_.spans(); ++j) {
      bool apart = false;
      for (int k = 0; k < a_.dimension(); ++k)
        apart = apart || a_[i].low[k] > b_[j].high[k] + tolerance_ ||
                b_[j].low[k] > a_[i].high[k] + tolerance_;
      if (apart)
        ++found_.excluded;
      else
        pairs_.emplace_back(i, j);
    }
}

void CurveSearch::examine(int index_a, int index_b) {
  const CurvePair pair{a_, a_[index_a], b_, b_[index_b]};
  if (boxes_apart(pair, tolerance_)) {
    ++found_.excluded;
    return;
  }
  a_.direct(index_a);
  b_.direct(index_b);
  if (itself_ && index_a == index_b) {
    if (turns_little(pair.a, pair.a, 1)) return;
    if (pair.a.extent <= tolerance_ + 8 * pair.a.margin) return add_contact(pair, found_.contacts);
    return halve(index_a, index_b, true);
  }
  const FatLines lines(pair, tolerance_);
  if (lines.separated()) {
    ++found_.excluded;
    return;
  }
  if (is_shared(pair)) return;
  const bool joined = itself_ && are_neighbours(pair.a, pair.b);
  if (joined && turns_little(pair.a, pair.b, 1)) return;
  if (!joined) {
    if (const auto points = line_points(pair, tolerance_, longest_valley_))
      return add_points(pair, *points);
    const auto sine = least_sine(pair);
    if (sine && settle(pair, *sine)) {
      ++found_.certified;
      return;
    }
    const auto valley = sine ? std::nullopt : valley_points(pair, tolerance_, longest_valley_);
    if (valley && !valley->contact) return add_points(pair, *valley);
    // Of one curve the contact may be the beginning of a cusp, which is told as a whole.
    if (valley && !itself_) return add_contact(pair, valley->a, valley->b, found_.contacts);
  }
  // Boxes and strips are no smaller than the rounding they contain.
  const double least = tolerance_ + 8 * (pair.a.margin + pair.b.margin);
  const bool small = std::max(pair.a.extent, pair.b.extent) <= least;
  const bool narrow = !joined && lines.within_strip(least);
  // A strip that holds a point of one curve and a long piece of the other is no contact all along.
  const double longer = std::max(pair.a.extent, pair.b.extent);
  const bool alike = kAlike * std::min(pair.a.extent, pair.b.extent) >= longer;
  if (small || (narrow && alike)) return add_contact(pair, found_.contacts);
  if (narrow) return halve(index_a, index_b, pair.a.extent == longer);
  const bool first = first_is_larger(pair);
  // Neighbours on one curve are never apart where they join.
  if (itself_ || !clip(index_a, index_b, lines)) halve(index_a, index_b, first);
}

void CurveSearch::add_points(const CurvePair& pair, const ValleyPoints& points) {
  ++found_.certified;
  for (int i = 0; i < points.count; ++i) {
    ValleyPoint point = points.points[static_cast<std::size_t>(i)];
    if (!point.touch) {
      const double rounding = 4 * pair.margin() / sine_between(point.foot);
      point.foot = at_common_end(pair, point.foot, rounding);
    }
    found_.points.push_back(point);
  }
}

// Leaves the parts of both cells that may be near each other, if that is less than halves would.
bool CurveSearch::clip(int index_a, int index_b, const FatLines& lines) {
  const auto parts = lines.parts();
  if (!parts) {
    ++found_.excluded;
    return true;
  }
  const bool less_of_a = length(parts->a) <= kWorthClipping;
  const bool less_of_b = length(parts->b) <= kWorthClipping;
  if (!less_of_a && !less_of_b) return false;
  const int a = less_of_a ? a_.part(index_a, parts->a) : index_a;
  pairs_.emplace_back(a, less_of_b ? b_.part(index_b, parts->b) : index_b);
  return true;
}

void CurveSearch::halve(int index_a, int index_b, bool first) {
  if (itself_ && index_a == index_b) {
    const int child = a_.split(index_a);
    pairs_.emplace_back(child, child);
    pairs_.emplace_back(child, child + 1);
    pairs_.emplace_back(child + 1, child + 1);
    return;
  }
  const int child = first ? a_.split(index_a) : b_.split(index_b);
  for (const int half : {child, child + 1})
    pairs_.emplace_back(first ? half : index_a, first ? index_b : half);
}

// A pair of pieces that run through the common part: with little turning they meet only there.
bool CurveSearch::is_shared(const CurvePair& pair) const {
  for (const SharedSpans& known : *shared_) {
    if (known.span_a != pair.a.span || known.span_b != pair.b.span) continue;
    const LinearRational& map = known.shared.map;
    const Interval part{std::max(pair.a.local.from, map.from.from),
                        std::min(pair.a.local.to, map.from.to)};
    if (part.from > part.to || !overlap(image(map, part), pair.b.local)) continue;
    if (turns_little(pair.a, pair.b, map.to.to > map.to.from ? 1 : -1)) return true;
  }
  return false;
}

bool CurveSearch::are_neighbours(const CurveCell& a, const CurveCell& b) const {
  if (a.span == b.span) return overlap(a.local, b.local);
  const auto follows = [&](const CurveCell& x, const CurveCell& y) {
    const bool next = y.span == x.span + 1;
    const bool seam = a_.closed() && x.span == a_.spans() - 1 && y.span == 0;
    return (next || seam) && x.local.to == 1 && y.local.from == 0;
  };
  return follows(a, b) || follows(b, a);
}

void CurveSearch::add_contact(const CurvePair& pair, std::vector<CurveContact>& list) {
  add_contact(pair, pair.a.local, pair.b.local, list);
}

void CurveSearch::add_contact(const CurvePair& pair, const Interval& a, const Interval& b,
                              std::vector<CurveContact>& list) {
  const auto range = [](const CurveTree& tree, const CurveCell& cell, const Interval& part) {
    return Interval{tree.parameter({cell.span, part.from}), tree.parameter({cell.span, part.to})};
  };
  list.push_back({range(a_, pair.a, a), range(b_, pair.b, b), dot(pair.a.axis, pair.b.axis) < 0,
                  itself_ && are_neighbours(pair.a, pair.b)});
}

// The ends of both spans, if they are one point bit for bit and the place is there to rounding.
CurveFoot CurveSearch::at_common_end(const CurvePair& pair, const CurveFoot& foot,
                                     double rounding) const {
  const auto end_of = [&](const SpanPoint& at, const CurveJet& jet) -> SpanPoint {
    const double end = at.t < 0.5 ? 0 : 1;
    const bool near = std::abs(at.t - end) * norm(jet.first) <= rounding;
    return {at.span, near ? end : at.t};
  };
  const SpanPoint a = end_of(foot.a, foot.jet_a), b = end_of(foot.b, foot.jet_b);
  const auto is_end = [](double t) { return t == 0 || t == 1; };
  const bool common = is_end(a.t) && is_end(b.t) && a_.end_point(a) == b_.end_point(b);
  return common ? foot_at(pair, a, b) : foot;
}

// The one common point that a pair with directions apart can have. False if it is not decided.
bool CurveSearch::settle(const CurvePair& pair, double sine) {
  const bool planar = pair.dimension() == 2;
  const auto found = nearest_feet(pair, chord_feet(pair));
  if (!found) return false;
  const double rounding = 4 * pair.margin() / sine;
  const double reach = planar ? rounding : 2 * (tolerance_ + pair.margin()) / sine;
  const auto inside = [](double t, const Interval& cell, double slack) {
    return t >= cell.from - slack && t <= cell.to + slack;
  };
  const double speed_a = norm(found->jet_a.first), speed_b = norm(found->jet_b.first);
  if (!inside(found->a.t, pair.a.local, reach / speed_a + kParameterSlack) ||
      !inside(found->b.t, pair.b.local, reach / speed_b + kParameterSlack))
    return planar && settle_outside(pair, *found);
  const bool on_spans = inside(found->a.t, {0, 1}, rounding / speed_a + kParameterSlack) &&
                        inside(found->b.t, {0, 1}, rounding / speed_b + kParameterSlack);
  if (!on_spans) return true;  // an end of a span is nearest: ends are examined apart
  CurveFoot foot = at_common_end(pair, *found, rounding);
  const double s = std::clamp(foot.a.t, 0.0, 1.0), t = std::clamp(foot.b.t, 0.0, 1.0);
  if (s != foot.a.t || t != foot.b.t) foot = foot_at(pair, {foot.a.span, s}, {foot.b.span, t});
  const double gap = norm(foot.gap());
  if (gap > tolerance_ + pair.margin()) return false;
  ValleyPoint point{foot,
                    false,
                    {std::max(0.0, gap - 2 * pair.margin()), gap + 2 * pair.margin()},
                    (tolerance_ + pair.margin()) / sine};
  point.touch = !planar && gap > 4 * pair.margin();
  found_.points.push_back(point);
  return true;
}

// The common point of the curves' continuations lies outside: proven by the cones at the nearest
// border.
bool CurveSearch::settle_outside(const CurvePair& pair, CurveFoot foot) {
  const auto clamped = [](double t, const Interval& cell) {
    return std::clamp(t, cell.from, cell.to);
  };
  const double t = clamped(foot.a.t, pair.a.local);
  const bool moved = t != foot.a.t;
  foot = foot_at(pair, {foot.a.span, t}, {foot.b.span, clamped(foot.b.t, pair.b.local)});
  // Where the other curve lies straight ahead of the border.
  if (moved) {
    const double step = cross_z(pair.a.axis, foot.gap()) / cross_z(pair.a.axis, foot.jet_b.first);
    foot = foot_at(pair, foot.a, {foot.b.span, clamped(foot.b.t + step, pair.b.local)});
  } else {
    const double step = -cross_z(pair.b.axis, foot.gap()) / cross_z(pair.b.axis, foot.jet_a.first);
    foot = foot_at(pair, {foot.a.span, clamped(foot.a.t + step, pair.a.local)}, foot.b);
  }
  return cones_exclude(pair, foot);
}

std::vector<SpanPoint> feet_near(CurveTree& tree, const Vec3& point, double tolerance) {
  struct Waiting {
    int cell;
    Interval part;
  };
  std::vector<Waiting> cells;
  const auto add = [&](int index) {
    if (box_distance(tree[index], point, tree.dimension()) > tolerance) return;
    tree.direct(index);
    const auto part = part_near(tree, tree[index], point, tolerance);
    if (!part) return;
    if (cells.empty()) cells.reserve(kFirstRoom);
    cells.push_back({index, *part});
  };
  std::vector<SpanPoint> feet;
  for (int i = 0; i < tree.spans(); ++i) add(i);
  while (!cells.empty()) {
    const auto [index, part] = cells.back();
    cells.pop_back();
    const CurveCell& cell = tree[index];
    if (cell.cosine < kOneComponent && cell.extent > tolerance + 8 * cell.margin) {
      if (length(part) <= kWorthClipping) {
        add(tree.part(index, part));
        continue;
      }
      const int child = tree.split(index);
      add(child);
      add(child + 1);
      continue;
    }
    const SpanPoint foot = foot_in(tree, cell, point);
    if (distance(tree.jet(foot).point, point) <= tolerance + tree.evaluation_margin())
      feet.push_back(foot);
  }
  return feet;
}

SpanPoint foot_along(const CurveTree& tree, const Vec3& point, double parameter) {
  SpanPoint at = tree.place(parameter);
  for (int k = 0; k < kAlongSteps; ++k) {
    const CurveJet jet = tree.jet(at);
    const double square = dot(jet.first, jet.first);
    if (!(square > 0)) break;
    const double next = at.t + dot(jet.first, point - jet.point) / square;
    if (std::abs(next - at.t) <= kParameterRounding) break;
    if (next > 1 && at.t == 1 && at.span + 1 < tree.spans())
      at = {at.span + 1, 0};
    else if (next < 0 && at.t == 0 && at.span > 0)
      at = {at.span - 1, 1};
    else
      at.t = std::clamp(next, 0.0, 1.0);
  }
  return at;
}

}  // namespace blossom
