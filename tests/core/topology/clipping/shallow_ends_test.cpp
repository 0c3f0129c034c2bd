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
  EXPECT_NEAR(parts[1].from, kCrossing, 1e-8) << "which begins there";
}

// The side of the square runs along the other plane but for rounding: no place of it is told by
// where it goes through.
TEST(ShallowEnds, StayWhereTheWireRunsAlongTheOtherSurface) {
  const FaceTrims a = square();
  for (const double tilt : {0.0, 1e-16, -3e-16, 2e-15, 1e-12}) {
    FaceTrims b = upright();
    b.jet = [tilt](const Vec2& uv) {
      return SurfaceJet{{uv[0], tilt * (uv[0] - kCrossing), uv[1]}, {1, tilt, 0}, {0, 0, 1}};
    };
    const auto jet = [](double x) {
      return HermiteJet{{{x, 0, 0}, {x, 0}, {x, 0}}, {{1, 0, 0}, {1, 0}, {1, 0}}};
    };
    IntersectionCurve curve = hermite_curve({jet(-1), jet(2), jet(5)}, {-1, 5});
    curve.deviation = {1e-12, 0, 1e-12};
    std::vector<Interval> parts{{0.5, 3.25}};
    move_shallow_ends(curve, a, &b, kOnWire, parts);
    EXPECT_EQ(parts.front(), (Interval{0.5, 3.25})) << tilt;
  }
}

// It crosses the side twice, 0.02 apart: each end keeps to its own place.
TEST(ShallowEnds, DoNotGoToTheNextPlace) {
  const FaceTrims a = square();
  constexpr double kBend = 1e-3, kHalf = 0.01, kOff = 4e-9;  // y = bend ((x - 2)^2 - half^2)
  FaceTrims b = upright();
  b.jet = [](const Vec2& uv) {
    const double x = uv[0] - kCrossing;
    return SurfaceJet{
        {uv[0], kBend * (x * x - kHalf * kHalf), uv[1]}, {1, 2 * kBend * x, 0}, {0, 0, 1}};
  };
  const auto jet = [](double x) {
    const double s = x - kCrossing, y = kBend * (s * s - kHalf * kHalf) + kOff,
                 slope = 2 * kBend * s;
    return HermiteJet{{{x, y, 0}, {x, y}, {x, 0}}, {{1, slope, 0}, {1, slope}, {1, 0}}};
  };
  IntersectionCurve curve = hermite_curve({jet(-1), jet(1), jet(3), jet(5)}, {-1, 5});
  curve.deviation = {kOff, 0, kOff};
  const double wrong = kOff / (2 * kBend * kHalf);
  std::vector<Interval> parts{{0.5, kCrossing - kHalf + wrong}, {kCrossing + kHalf - wrong, 3.5}};
  move_shallow_ends(curve, a, &b, kOnWire, parts);
  EXPECT_NEAR(parts[0].to, kCrossing - kHalf, 1e-7);
  EXPECT_NEAR(parts[1].from, kCrossing + kHalf, 1e-7);
}

}  // namespace
}  // namespace blossom
