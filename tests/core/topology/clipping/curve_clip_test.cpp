// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/topology/clipping/curve_clip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "tests/support/flat_trims.h"

namespace blossom {
namespace {

using std::numbers::pi;
using testing::FlatLoops;
using testing::half_disc;
using testing::square_without_disc;

Spline2 line(const Vec2& from, const Vec2& to) { return {1, {0, 1}, {2, 2}, {from, to}}; }

FaceTrims square_with_gap(double gap) {
  FlatLoops loops;
  loops.add_polygon({{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}}, gap);
  return testing::trims_of(std::move(loops));
}

void expect_intervals(const std::vector<Interval>& found, const std::vector<Interval>& wanted) {
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_NEAR(found[i].from, wanted[i].from, 1e-9);
    EXPECT_NEAR(found[i].to, wanted[i].to, 1e-9);
  }
}

TEST(ClipToTrims, LeavesWhatIsInsideOfOneLoopAndOutsideOfAnother) {
  const FaceTrims trims = square_without_disc();
  expect_intervals(clip_to_trims(trims, line({0.5, 0.5}, {0.5, 3.5})), {{0, 1}});
  expect_intervals(clip_to_trims(trims, line({-4, 2}, {8, 2})),
                   {{1.0 / 3, 5.0 / 12}, {7.0 / 12, 2.0 / 3}});
  expect_intervals(clip_to_trims(trims, line({5, 1}, {6, 1})), {});
}

TEST(ClipToTrims, OfACurveThatOnlyTouchesIsAPoint) {
  expect_intervals(clip_to_trims(square_without_disc(), line({-1, 1}, {1, -1})), {{0.5, 0.5}});
}

TEST(ClipToTrims, TakesPeriodsOff) {
  FlatLoops loops;
  loops.add_polygon({{1, 0}, {3, 0}, {3, 3}, {1, 3}});
  SurfaceChart tube = testing::plane_chart();
  tube.period = {2 * pi, 0};
  const auto trims = trims_of(tube, std::move(loops.vertices), std::move(loops.loops));
  ASSERT_TRUE(trims);
  expect_intervals(clip_to_trims(*trims, line({2 * pi, 1}, {2 * pi + 4, 1})), {{0.25, 0.75}});
}

// A spline round the origin, over [0, 1], from 0.2 to 3 radians: radius 1, 32 waves of this height,
// and a bump of another one over the middle fifth.
Spline2 waves_round_origin(double height, double bump) {
  constexpr int kSpans = 256;
  const auto place = [&](double t) {
    const double across = std::max(0.0, 1 - std::abs(t - 0.5) / 0.1);
    const double radius = 1 + height * std::cos(64 * pi * t) + bump * across * across;
    const double angle = 0.2 + 2.8 * t;
    return Vec2{radius * std::cos(angle), radius * std::sin(angle)};
  };
  const auto slope = [&](double t) { return (0.5 / 1e-6) * (place(t + 1e-6) - place(t - 1e-6)); };
  Spline2 spline{3, {}, {}, {place(0)}};
  for (int i = 0; i <= kSpans; ++i) {
    spline.knots.push_back(static_cast<double>(i) / kSpans);
    spline.multiplicities.push_back(i == 0 || i == kSpans ? 4 : 3);
    if (i == kSpans) break;
    const double from = spline.knots.back(), to = (i + 1.0) / kSpans, third = (to - from) / 3;
    spline.points.push_back(place(from) + third * slope(from));
    spline.points.push_back(place(to) - third * slope(to));
    spline.points.push_back(place(to));
  }
  return spline;
}

// About as far from the edge as may count as a meeting, with the edge's own tolerance of 1e-7.
TEST(ClipToTrims, CurveThatWeavesAlongAWireIsWhole) {
  const FaceTrims trims = half_disc();
  expect_intervals(clip_to_trims(trims, waves_round_origin(1.2e-7, 0)), {{0, 1}});
  expect_intervals(clip_to_trims(trims, waves_round_origin(3e-8, 0)), {{0, 1}});
}

TEST(ClipToTrims, CurveThatWeavesAlongAWireIsCutWhereItLeavesIt) {
  const std::vector<Interval> parts = clip_to_trims(half_disc(), waves_round_origin(1.2e-7, 1e-3));
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].from, 0);
  EXPECT_NEAR(parts[0].to, 0.4, 0.005);
  EXPECT_NEAR(parts[1].from, 0.6, 0.005);
  EXPECT_EQ(parts[1].to, 1);
}

// Between arc and diameter of a half disc, within tolerance of its corner: one meeting there,
// however the curve runs.
TEST(ClippedCurve, HasOneMeetingInTheCornerOfTwoEdgesThatItTouches) {
  const FaceTrims trims = half_disc();
  const Vec2 below{1 - 1e-8 + 1e-5, -0.1}, above{1 - 1e-8 - 1e-5, 0.1};
  for (const Spline2& cut : {line(below, above), line(above, below)}) {
    const PlanarCurve curve = chart_curve(trims, cut);
    const ClippedCurve found = clipped(trims, curve, 1e-7);
    ASSERT_EQ(found.meetings.size(), 1);
    const Vec2 point = point_at(curve, found.meetings[0].at);
    EXPECT_NEAR(point[0] / trims.scale[0], 1, 2e-8);
    EXPECT_NEAR(point[1] / trims.scale[1], 0, 1e-7);
  }
}

TEST(ClipToTrims, CurveIsCutInTheGapOfAWire) {
  expect_intervals(clip_to_trims(square_with_gap(1e-3), line({2.0005, -1}, {2.0005, 5})),
                   {{1.0 / 6, 5.0 / 6}});
}

TEST(ClippedCurve, MeetsAnEndOfAnEdgeInTheGapOfAWire) {
  const FaceTrims trims = square_with_gap(1e-3);
  const ClippedCurve found =
      clipped(trims, chart_curve(trims, line({2.0005, -1}, {2.0005, 3})), 1e-7);
  ASSERT_EQ(found.meetings.size(), 1u);
  EXPECT_NEAR(found.meetings[0].at, 0.25, 1e-12);
  const Coedge& met = trims.loops.front()[static_cast<std::size_t>(found.meetings[0].coedge)];
  const Vec2 end = point_at(met.curve, found.meetings[0].edge_parameter);
  EXPECT_NEAR(end[0] / trims.scale[0], 2, 1.1e-3);
}

TEST(DistanceOutwards, IsZeroInsideAndElseThatOfTheNearestWire) {
  const FaceTrims trims = square_without_disc();
  EXPECT_EQ(distance_outwards(trims, {0.5, 0.5}), 0);
  EXPECT_NEAR(distance_outwards(trims, {5, 1}), 1, 1e-12);
  EXPECT_NEAR(distance_outwards(trims, {2, 2.25}), 0.75, 1e-12);
}

}  // namespace
}  // namespace blossom
