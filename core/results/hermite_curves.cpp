// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/results/hermite_curves.h"

#include <algorithm>
#include <cstddef>

namespace blossom {

// With double knots the pole that two pieces share is not stored.
IntersectionCurve hermite_curve(const std::vector<HermiteJet>& jets, const Interval& range) {
  IntersectionCurve curve;
  const int pieces = static_cast<int>(jets.size()) - 1;
  const double third = length(range) / pieces / 3;
  const auto add = [&](const HermiteJet& jet, double step) {
    curve.curve.points.push_back(jet.value.point + step * jet.rate.point);
    curve.chart_a.points.push_back(jet.value.uv_a + step * jet.rate.uv_a);
    curve.chart_b.points.push_back(jet.value.uv_b + step * jet.rate.uv_b);
  };
  for (int i = 0; i <= pieces; ++i) {
    const HermiteJet& jet = jets[static_cast<std::size_t>(i)];
    const bool inner = i > 0 && i < pieces;
    if (i > 0) add(jet, -third);
    if (!inner) add(jet, 0);
    if (i < pieces) add(jet, third);
    curve.curve.knots.push_back(at(range, static_cast<double>(i) / pieces));
    curve.curve.multiplicities.push_back(inner ? 2 : 4);
    curve.samples.push_back(jet.value);
    curve.sample_parameters.push_back(curve.curve.knots.back());
  }
  curve.curve.degree = curve.chart_a.degree = curve.chart_b.degree = 3;
  curve.chart_a.knots = curve.chart_b.knots = curve.curve.knots;
  curve.chart_a.multiplicities = curve.chart_b.multiplicities = curve.curve.multiplicities;
  return curve;
}

void raise(Deviation& most, const Deviation& least) {
  most.a = std::max(most.a, least.a);
  most.b = std::max(most.b, least.b);
  most.between = std::max(most.between, least.between);
}

}  // namespace blossom
