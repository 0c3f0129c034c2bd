// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/spans/arc_spans.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/forms/spans/homogeneous.h"

namespace blossom {
namespace {

/// cos and sin of multiples of pi / 2 miss 0 by about this much.
constexpr double kZeroOfAngle = 4e-16;

double snapped(double x) { return std::abs(x) <= kZeroOfAngle ? 0.0 : x; }

}  // namespace

std::vector<ArcSpan> arc_spans(const Interval& angles, ArcCuts cuts) {
  constexpr double kOffEven = 0.113;    // of a span
  constexpr double kRoundTurn = 1e-12;  // part of a turn: what is missing is rounding
  const double turn = 2 * std::numbers::pi;
  const double size = length(angles);
  const int count = std::max(1, static_cast<int>(std::ceil(size / (turn / 4) - kQuarterSlack)));
  const bool whole = std::abs(size - turn) <= kRoundTurn * turn;
  std::vector<ArcSpan> spans;
  const double off = cuts == ArcCuts::Shifted ? kOffEven * (size / count) : 0;
  const auto start = [&](int i) {
    return i == 0 ? angles.from : angles.from + i * (size / count) + off;
  };
  for (int i = 0; i < count; ++i) {
    const double from = start(i);
    const double to = i + 1 == count ? angles.to : start(i + 1);
    const double end = whole && i + 1 == count ? angles.from : to;
    const double middle = (from + to) / 2;
    spans.push_back({{from, to},
                     {snapped(std::cos(from)), snapped(std::cos(middle)), snapped(std::cos(end))},
                     {snapped(std::sin(from)), snapped(std::sin(middle)), snapped(std::sin(end))},
                     {1, std::cos((to - from) / 2), 1}});
  }
  return spans;
}

CurveSpans ellipse_spans(const Vec3& origin, const Vec3& a, const Vec3& b, const Interval& range,
                         ArcCuts cuts) {
  CurveSpans result;
  result.rational = true;
  for (const ArcSpan& arc : arc_spans(range, cuts)) {
    RationalBezierCurve curve;
    for (int k = 0; k < 3; ++k)
      curve.points.push_back(
          with_weight(arc.weight[k] * origin + arc.cosine[k] * a + arc.sine[k] * b, arc.weight[k]));
    result.spans.push_back({std::move(curve), arc.place, ParameterLaw::Angle});
  }
  return result;
}

CurveSpans hyperbola_spans(const Vec3& origin, const Vec3& a, const Vec3& b,
                           const Interval& range) {
  constexpr double kLongest = 2;
  CurveSpans result;
  result.rational = true;
  const int count = std::max(1, static_cast<int>(std::ceil(length(range) / kLongest)));
  for (int i = 0; i < count; ++i) {
    const Interval place{at(range, i / double(count)), at(range, (i + 1) / double(count))};
    RationalBezierCurve curve;
    for (const double t : {place.from, at(place, 0.5), place.to}) {
      const double weight = curve.points.size() == 1 ? std::cosh(0.5 * length(place)) : 1;
      curve.points.push_back(
          with_weight(weight * origin + std::cosh(t) * a + std::sinh(t) * b, weight));
    }
    result.spans.push_back({std::move(curve), place, ParameterLaw::Hyperbolic});
  }
  return result;
}

}  // namespace blossom
