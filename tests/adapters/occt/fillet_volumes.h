// SPDX-License-Identifier: LGPL-2.1-or-later
// Fillets of single edges whose volumes are known.

#pragma once

#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <BRepCheck_Analyzer.hxx>

#include "adapters/occt/edge_facts.h"
#include "adapters/occt/fillet.h"

namespace blossom::testing {

/// A ball of radius 1 leaves so much of a square's corner, in the plane.
inline constexpr double kCut = 1 - std::numbers::pi / 4;

/// Numbers of the edges of a kind whose middles fit.
template <class Fits>
std::vector<int> edges_where(const TopoDS_Shape& shape, occt::EdgeKind kind, const Fits& fits) {
  std::vector<int> found;
  for (const occt::EdgeFacts& each : occt::edge_facts(shape))
    if (each.kind == kind && fits(each.middle)) found.push_back(each.number);
  return found;
}

/// Valid, whole, and as much more as was said.
inline void expect_change(const occt::FilletResult& made, double more, double error) {
  for (const occt::FilletRefusal& each : made.refused) ADD_FAILURE() << each.text();
  for (const std::string& each : made.notes) ADD_FAILURE() << each;
  ASSERT_EQ(made.solids.size(), 1U);
  EXPECT_TRUE(BRepCheck_Analyzer(made.solids.front().solid).IsValid());
  EXPECT_NEAR(made.solids.front().volume - made.volume_before, more, error);
}

/// The sum of a function's values between two points, by Simpson's rule.
template <class F>
double integral(double from, double to, const F& f) {
  constexpr int kSteps = 20000;
  const double step = (to - from) / kSteps;
  double sum = f(from) + f(to);
  for (int i = 1; i < kSteps; ++i) sum += (i % 2 == 1 ? 4 : 2) * f(from + i * step);
  return sum * step / 3;
}

}  // namespace blossom::testing
