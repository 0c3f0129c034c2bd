// SPDX-License-Identifier: LGPL-2.1-or-later
// Ends of curves at wires that they cross at a small angle.
#include "core/topology/clipping/shallow_ends.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "core/results/hermite_curves.h"
#include "tests/support/flat_trims.h"

namespace blossom {
namespace {

constexpr double kSlope = 1e-5;
constexpr double kCrossing = 2;  // where y = slope (x - 2) crosses the lower side of the square

FaceTrims square() {
  testing::FlatLoops loops;
  loops.add_polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  return *trims_of(testing::plane_chart(), loops.vertices, loops.loops);
}

// The plane through that line, upright, by x and z; its wires are far away.
FaceTrims upright() {
  testing::FlatLoops loops;
  loops.add_polygon({{-9, -9}, {9, -9}, {9, 9}, {-9, 9}});
  SurfaceChart chart = testing::plane_chart();
  chart.jet = [](const Vec2& uv) {
    return SurfaceJet{{uv[0], kSlope * (uv[0] - kCrossing), uv[1]}, {1, kSlope, 0}, {0, 0, 1}};
  };
  return *trims_of(chart, loops.vertices, loops.loops);
}

// The line, by x, and by so much too high.
IntersectionCurve line_off_by(double high, double stated) {
  const auto jet = [&](double x) {
    const double y = kSlope * (x - kCrossing) + high;
    return HermiteJet{{{x, y, 0}, {x, y}, {x, 0}}, {{1, kSlope, 0}, {1, kSlope}, {1, 0}}};
  };
  IntersectionCurve curve = hermite_curve({jet(-1), jet(1), jet(3), jet(5)}, {-1, 5});
  curve.deviation = {stated, 0, stated};
  return curve;
}

TEST(ShallowEnds, AreWhereTheWireGoesThroughTheOtherSurface) {
  const FaceTrims a = square(), b = upright();
  constexpr double kOff = 4e-9;
  for (const double high : {-kOff, kOff})
    for (const bool swapped : {false, true}) {
      const double wrong = kCrossing - high / kSlope;
      IntersectionCurve curve = line_off_by(high, kOff);
      if (swapped) std::swap(curve.chart_a, curve.chart_b);
      std::vector<Interval> parts{{wrong, 3.5}};
      move_shallow_ends(curve, swapped ? b : a, swapped ? &a : &b, kOnWire, parts);
      ASSERT_EQ(parts.size(), 1u);
      EXPECT_NEAR(parts.front().from, kCrossing, 1e-8);
      EXPECT_EQ(parts.front().to, 3.5);  // not on a wire
    }
}

TEST(ShallowEnds, StayWhereTheyAreKnownWellOrTheCurveKeepsOffThePlace) {
  const FaceTrims a = square(), b = upright();
  const double kept = kCrossing + 0.05;
  std::vector<Interval> parts{{kept, 3.5}};
  move_shallow_ends(line_off_by(0, 1e-9), a, &b, kOnWire, parts);
  EXPECT_EQ(parts.front().from, kept) << "off the wire by more than it may be";
  constexpr double kTooHigh = 1e-6;
  const double wrong = kCrossing - kTooHigh / kSlope;
  parts = {{wrong, 3.5}};
  move_shallow_ends(line_off_by(kTooHigh, 1e-9), a, &b, kOnWire, parts);
  EXPECT_EQ(parts.front().from, wrong);
  move_shallow_ends(line_off_by(kTooHigh, 1e-9), a, nullptr, kOnWire, parts);
  EXPECT_EQ(parts.front().from, wrong);
}

TEST(ShallowEnds, LeaveTheRoomOfOtherParts) {
  const FaceTrims a = square(), b = upright();
  const double wrong = kCrossing - 4e-4;
  std::vector<Interval> parts{{0.5, wrong}, {kCrossing - 1e-4, 3.5}};
  move_shallow_ends(line_off_by(4e-9, 4e-9), a, &b, kOnWire, parts);
  EXPECT_EQ(parts[0].to, wrong) << "the place lies in the next part";
}

}  // namespace
}  // namespace blossom
