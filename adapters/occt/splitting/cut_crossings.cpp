// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/splitting/cut_crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace blossom::occt {
namespace {

constexpr double kMargin = 1.1;

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

// Half way; both ends of the curve where the stretch leads over its end.
std::vector<double> touch_at(const PlanarCurve& curve, const Stretch& of) {
  const Interval domain = curve.domain();
  if (of.over_end) return {domain.from, domain.to};
  return {at(of.at, 0.5)};
}

// The one place in which cuts touch that cross twice; none if they do not keep together.
std::optional<CutCrossing> one_touch(const PlanarCurve& a, const PlanarCurve& b,
                                     const CutCrossing& first, const CutCrossing& second,
                                     double tolerance, double longest) {
  const Stretch on_a = stretch(a, first.a.front(), second.a.front(), tolerance);
  const Stretch on_b = stretch(b, first.b.front(), second.b.front(), tolerance);
  if (chords(a, on_a) > longest || chords(b, on_b) > longest || !keeps_to(a, on_a, b, tolerance) ||
      !keeps_to(b, on_b, a, tolerance))
    return {};
  CutCrossing touch{touch_at(a, on_a), touch_at(b, on_b), {}};
  touch.point = on_b.over_end ? point_at(b, touch.b.front()) : point_at(a, touch.a.front());
  touch.blur = kMargin * std::max(first.blur + distance(touch.point, first.point),
                                  second.blur + distance(touch.point, second.point));
  return touch;
}

}  // namespace

CutCrossings cut_crossings(const PlanarCurve& a, const PlanarCurve& b, double tolerance,
                           double longest) {
  const PlanarCrossings common = crossings(a, b, tolerance);
  CutCrossings found{{}, common.complete};
  auto& nodes = found.nodes;
  const auto joined = [&](const CutCrossing& first, const CutCrossing& second) {
    return one_touch(a, b, first, second, tolerance, longest);
  };
  for (const PlanarCrossing& point : common.points) {
    const CutCrossing node{{point.a}, {point.b}, point.point};
    const auto touch = nodes.empty() ? std::nullopt : joined(nodes.back(), node);
    if (touch)
      nodes.back() = *touch;
    else
      nodes.push_back(node);
  }
  if (nodes.size() < 2) return found;
  if (const auto touch = joined(nodes.back(), nodes.front())) {  // round the end of a
    nodes.front() = *touch;
    nodes.pop_back();
  }
  return found;
}

}  // namespace blossom::occt
