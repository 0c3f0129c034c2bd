// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/splitting/cut_crossings.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace blossom::occt {
namespace {

constexpr double kMargin = 1.1;
constexpr double kShared = 1e-4;  // of the tolerance: so near each other are cuts that share a run

// From one parameter of a curve to another, over the end of a closed one where that is shorter.
struct Stretch {
  Interval at;  // increasing
  bool over_end = false;
};

Stretch stretch(const PlanarCurve& curve, double s, double t, double tolerance) {
  const Interval domain = curve.domain(), at{std::min(s, t), std::max(s, t)};
  const bool closed =
      distance(point_at(curve, domain.from), point_at(curve, domain.to)) <= tolerance;
  return {at, closed && 2 * length(at) > length(domain)};
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
        common_(crossings(a, b, tolerance)) {}

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

  Stretch on_a(const PlanarCrossing& p, const PlanarCrossing& q) const {
    return stretch(a_, p.a, q.a, tolerance_);
  }
  Stretch on_b(const PlanarCrossing& p, const PlanarCrossing& q) const {
    return stretch(b_, p.b, q.b, tolerance_);
  }

  bool goes_over_end(const PlanarCrossing& p, const PlanarCrossing& q) const {
    return on_a(p, q).over_end;
  }

  // Whether the cuts keep together between them, and are not known to share a run.
  bool are_one(const PlanarCrossing& p, const PlanarCrossing& q) const {
    const Stretch of_a = on_a(p, q), of_b = on_b(p, q);
    return chords(a_, of_a) <= longest_ && chords(b_, of_b) <= longest_ &&
           keeps_to(a_, of_a, b_, tolerance_) && keeps_to(b_, of_b, a_, tolerance_) &&
           std::ranges::none_of(common_.overlaps, [&](const PlanarOverlap& run) {
             return holds_part_of(of_a, run.a) && is_shared(run);
           });
  }

  // Beside a touch the distance grows as its square.
  bool is_shared(const PlanarOverlap& run) const {
    return std::ranges::all_of(std::array{0.25, 0.75}, [&](double part) {
      return nearest(b_, point_at(a_, at(run.a, part))).distance <= kShared * tolerance_;
    });
  }

  // Half way on a, and what is nearest to that on b; where one is closed and ends in the stretch,
  // that end decides.
  CutCrossing node_of(const Chain& chain) const {
    const auto& [first, last] = chain;
    if (first.a == last.a && first.b == last.b) return {{first.a}, {first.b}, first.point};
    const Stretch of_a = on_a(first, last), of_b = on_b(first, last);
    const auto ends = [](const PlanarCurve& curve) {
      return std::vector{curve.domain().from, curve.domain().to};
    };
    CutCrossing node;
    if (of_b.over_end) node.b = ends(b_);
    if (of_a.over_end) node.a = ends(a_);
    if (of_b.over_end && !of_a.over_end) {
      node.point = point_at(b_, node.b.front());
      node.a = {nearest(a_, node.point).parameter};
    } else {
      if (!of_a.over_end) node.a = {at(of_a.at, 0.5)};
      node.point = point_at(a_, node.a.front());
      if (!of_b.over_end) node.b = {nearest(b_, node.point).parameter};
    }
    node.blur =
        kMargin * std::max(distance(node.point, first.point), distance(node.point, last.point));
    return node;
  }

  const PlanarCurve& a_;
  const PlanarCurve& b_;
  const double tolerance_, longest_;
  const PlanarCrossings common_;
};

}  // namespace

CutCrossings cut_crossings(const PlanarCurve& a, const PlanarCurve& b, double tolerance,
                           double longest) {
  return Nodes(a, b, tolerance, longest).found();
}

}  // namespace blossom::occt
