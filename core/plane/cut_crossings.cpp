// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/plane/cut_crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/sampled_margin.h"

namespace blossom {
namespace {

constexpr double kShared = 1e-4;  // of the tolerance: so near each other are cuts that share a run

// From one parameter of a curve to another, over the end of a closed one where that is shorter.
struct Stretch {
  Interval at;  // increasing
  bool over_end = false;
};

bool is_closed(const PlanarCurve& curve, double tolerance) {
  const Interval domain = curve.domain();
  return distance(point_at(curve, domain.from), point_at(curve, domain.to)) <= tolerance;
}

Stretch stretch(const PlanarCurve& curve, double s, double t, double tolerance) {
  const Interval at{std::min(s, t), std::max(s, t)};
  return {at, 2 * length(at) > length(curve.domain()) && is_closed(curve, tolerance)};
}

double parameter(const PlanarCurve& curve, const Stretch& of, double part) {
  if (!of.over_end) return at(of.at, part);
  const Interval domain = curve.domain();
  const double around = length(domain) - length(of.at);
  const double t = of.at.to + part * around;
  return t <= domain.to ? t : t - length(domain);
}

double chords(const PlanarCurve& curve, const Stretch& of) {
  const Vec2 middle = point_at(curve, parameter(curve, of, 0.5));
  return distance(point_at(curve, of.at.from), middle) +
         distance(middle, point_at(curve, of.at.to));
}

bool keeps_to(const PlanarCurve& curve, const Stretch& of, const PlanarCurve& other,
              double tolerance) {
  return std::ranges::all_of(std::array{0.25, 0.5, 0.75}, [&](double part) {
    return nearest(other, point_at(curve, parameter(curve, of, part))).distance <= tolerance;
  });
}

bool holds_part_of(const Stretch& stretch, const Interval& run) {
  if (stretch.over_end) return run.to > stretch.at.to || run.from < stretch.at.from;
  return run.from < stretch.at.to && run.to > stretch.at.from;
}

class Nodes {
 public:
  Nodes(const PlanarCurve& a, const PlanarCurve& b, double tolerance, double longest)
      : a_(a),
        b_(b),
        tolerance_(tolerance),
        longest_(longest),
        common_(crossings(a, b, tolerance)) {
    add_ends(a, b, [](double end, double at) { return std::pair(end, at); });
    add_ends(b, a, [](double end, double at) { return std::pair(at, end); });
    std::ranges::stable_sort(common_.points, {}, &PlanarCrossing::a);
  }

  CutCrossings found() const {
    std::vector<Chain> chains;
    for (const PlanarCrossing& point : common_.points) {
      if (!chains.empty() && are_one(chains.back().first, point))
        chains.back().last = point;
      else
        chains.push_back({point, point});
    }
    if (chains.size() > 1 && goes_over_end(chains.back().first, chains.front().last) &&
        are_one(chains.back().first, chains.front().last)) {
      chains.front().first = chains.back().first;
      chains.pop_back();
    }
    CutCrossings found{{}, common_.complete};
    for (const Chain& chain : chains) found.nodes.push_back(node_of(chain));
    return found;
  }

 private:
  // Crossings that are one node, along a.
  struct Chain {
    PlanarCrossing first, last;
  };

  // The ends of an open curve that lie on the other one, of which a crossing beside may be told.
  template <class InOrder>
  void add_ends(const PlanarCurve& curve, const PlanarCurve& other, const InOrder& in_order) {
    if (common_.points.empty() || is_closed(curve, tolerance_)) return;
    for (const double end : {curve.domain().from, curve.domain().to}) {
      const PlanarFoot foot = nearest(other, point_at(curve, end));
      if (foot.distance > tolerance_) continue;
      const auto [on_a, on_b] = in_order(end, foot.parameter);
      common_.points.push_back({on_a, on_b, point_at(a_, on_a), false});
    }
  }

  Stretch on_a(const PlanarCrossing& p, const PlanarCrossing& q) const {
    return stretch(a_, p.a, q.a, tolerance_);
  }
  Stretch on_b(const PlanarCrossing& p, const PlanarCrossing& q) const {
    return stretch(b_, p.b, q.b, tolerance_);
  }

  bool goes_over_end(const PlanarCrossing& p, const PlanarCrossing& q) const {
    return on_a(p, q).over_end;
  }

  // Whether the cuts keep together between them, and are not known to share a run. The two ends of
  // an open one are two.
  bool are_one(const PlanarCrossing& p, const PlanarCrossing& q) const {
    const Stretch of_a = on_a(p, q), of_b = on_b(p, q);
    return !is_whole(a_, of_a) && !is_whole(b_, of_b) && chords(a_, of_a) <= longest_ &&
           chords(b_, of_b) <= longest_ && keeps_to(a_, of_a, b_, tolerance_) &&
           keeps_to(b_, of_b, a_, tolerance_) &&
           std::ranges::none_of(common_.overlaps, [&](const PlanarOverlap& run) {
             return holds_part_of(of_a, run.a) && is_shared(run);
           });
  }

  static bool is_whole(const PlanarCurve& curve, const Stretch& of) {
    const Interval domain = curve.domain();
    return !of.over_end && of.at.from == domain.from && of.at.to == domain.to;
  }

  // Beside a touch the distance grows as its square, so that its middle, too, keeps as near.
  bool is_shared(const PlanarOverlap& run) const {
    const double middle = std::sqrt(kShared) * longest_;
    return chords(a_, {run.a}) > middle &&
           std::ranges::all_of(std::array{0.25, 0.75}, [&](double part) {
             return nearest(b_, point_at(a_, at(run.a, part))).distance <= kShared * tolerance_;
           });
  }

  // Half way on a, and what is nearest to that on b; where one of them ends in the stretch, or is
  // closed and begins there, that end decides.
  CutCrossing node_of(const Chain& chain) const {
    const auto& [first, last] = chain;
    if (first.a == last.a && first.b == last.b) return {{first.a}, {first.b}, first.point};
    const Stretch of_a = on_a(first, last), of_b = on_b(first, last);
    CutCrossing node{end_in(a_, of_a), end_in(b_, of_b), {}};
    if (node.a.empty() && !node.b.empty()) {
      node.point = point_at(b_, node.b.front());
      node.a = {nearest(a_, node.point).parameter};
    } else {
      if (node.a.empty()) node.a = {at(of_a.at, 0.5)};
      node.point = point_at(a_, node.a.front());
      if (node.b.empty()) node.b = {nearest(b_, node.point).parameter};
    }
    node.uncertainty = kSampledMargin * std::max(distance(node.point, first.point),
                                                 distance(node.point, last.point));
    node.beside = {first.a, last.a};
    return node;
  }

  std::vector<double> end_in(const PlanarCurve& curve, const Stretch& of) const {
    const Interval domain = curve.domain();
    const bool first = of.at.from == domain.from, last = of.at.to == domain.to;
    if (of.over_end || ((first || last) && is_closed(curve, tolerance_)))
      return {domain.from, domain.to};
    if (!first && !last) return {};
    return {first ? domain.from : domain.to};
  }

  const PlanarCurve& a_;
  const PlanarCurve& b_;
  const double tolerance_, longest_;
  PlanarCrossings common_;
};

}  // namespace

CutCrossings cut_crossings(const PlanarCurve& a, const PlanarCurve& b, double tolerance,
                           double longest) {
  return Nodes(a, b, tolerance, longest).found();
}

double on_the_way(const PlanarCurve& curve, double from, double to, double part, double tolerance) {
  const Stretch way = stretch(curve, from, to, tolerance);
  return parameter(curve, way, (from <= to) == way.over_end ? 1 - part : part);
}

}  // namespace blossom
