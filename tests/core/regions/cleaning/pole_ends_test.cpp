// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/regions/cleaning/pole_ends.h"

#include <gtest/gtest.h>

#include "tests/support/region_checks.h"

namespace blossom {
namespace {

using testing::Chart;
using testing::heights;

constexpr double kPoleTolerance = 1e-7;

// A sector with its tip along v = 0.
BezierSurface sector() {
  BezierSurface surface = heights({0, 1}, {0, 1}, 1);
  RationalBezierPatch& patch = surface.patches(0, 0);
  patch.points(0, 0) = patch.points(1, 0) = {0, 0, 0, 1};
  patch.points(0, 1) = {1, 0, 0, 1};
  patch.points(1, 1) = {0.9, 0.4, 0, 1};
  return surface;
}

// Its left part, up to a border from the tip to (0.6, 1): at first it sweeps from u = 0.9 to hardly
// more than 0.6, no farther from the tip than 2e-7.
TrimmedChart passing() {
  const double u = 0.6 + 5e-9;
  Chart chart = Chart().loop({{{{0.6, 1, 1}, {0, 1, 1}}},
                              {{{0, 1, 1}, {0, 0, 1}}},
                              {{{0, 0, 1}, {0.9, 0, 1}}},
                              {{{0.9, 0, 1}, {u, 0, 1}, {u, 2e-7, 1}}}});
  chart.made.borders[3].curve.spans.push_back(
      {{{{u, 2e-7, 1}, {0.6, 0.5, 1}, {0.6, 1, 1}}}, {1, 2}, ParameterLaw::Linear});
  chart.made.borders[2].is_point = true;
  return chart.made;
}

TEST(PoleEnds, DoNotSweepOverTheChartBesideThePole) {
  const TrimmedChart given = passing();
  const TrimmedChart made = with_straight_pole_ends(sector(), given, kPoleTolerance);

  EXPECT_NEAR(made.corners[3][0], 0.6, 1e-7);
  EXPECT_EQ(made.corners[3][1], 0);
  EXPECT_EQ(point_at(made.borders[2].curve, 1), made.corners[3]);
  EXPECT_EQ(point_at(made.borders[3].curve, 0), made.corners[3]);
  for (int k = 0; k <= 20; ++k)
    EXPECT_DOUBLE_EQ(point_at(made.borders[3].curve, 0.1 * k)[0], made.corners[3][0]);
}

TEST(PoleEnds, MoveNoPointByMoreThanTheDistance) {
  const BezierSurface surface = sector();
  const TrimmedChart given = passing();
  const TrimmedChart made = with_straight_pole_ends(surface, given, kPoleTolerance);

  for (std::size_t b = 0; b < given.borders.size(); ++b) {
    const Interval domain = given.borders[b].curve.domain();
    for (int k = 0; k <= 50; ++k) {
      const double t = at(domain, k / 50.0);
      EXPECT_LE(distance(point_at(surface, point_at(given.borders[b].curve, t)),
                         point_at(surface, point_at(made.borders[b].curve, t))),
                kPoleTolerance);
    }
  }
}

TEST(PoleEnds, StayWhereTheyAreFartherThanThatFromStraightOnes) {
  const TrimmedChart given = passing();
  TrimmedChart bent = given;
  bent.borders[3].curve.spans[0].curve = {{{0.9, 0, 1}, {0.9, 0.1, 1}, {0.6, 0.2, 1}}};
  bent.borders[3].curve.spans[1].curve = {{{0.6, 0.2, 1}, {0.6, 1, 1}}};

  const TrimmedChart made = with_straight_pole_ends(sector(), bent, kPoleTolerance);

  EXPECT_EQ(made.corners[3], bent.corners[3]);
  for (int k = 0; k <= 20; ++k)
    EXPECT_EQ(point_at(made.borders[3].curve, 0.1 * k), point_at(bent.borders[3].curve, 0.1 * k));
}

// Without a pole, or with other borders at the corner, nothing is known of where it may go.
TEST(PoleEnds, StayWhereThereIsNoPole) {
  TrimmedChart given = passing();
  given.borders[2].is_point = false;
  const TrimmedChart made = with_straight_pole_ends(sector(), given, kPoleTolerance);
  EXPECT_EQ(made.corners, given.corners);
}

// The part between u = 0.2 and u = 0.8 with a corner beside the tip where both borders end that
// sweep there from their sides, no farther from the tip than 2e-8.
TrimmedChart touching() {
  Chart chart = Chart().loop({{{{0.8, 1, 1}, {0.2, 1, 1}}},
                              {{{0.2, 1, 1}, {0.2, 0.5, 1}, {0.2, 2e-8, 1}}},
                              {{{0.5, 1e-8, 1}, {0.8, 1e-8, 1}, {0.8, 2e-8, 1}}}});
  chart.made.borders[1].curve.spans.push_back(
      {{{{0.2, 2e-8, 1}, {0.2, 1e-8, 1}, {0.5, 1e-8, 1}}}, {1, 2}, ParameterLaw::Linear});
  chart.made.borders[2].curve.spans.push_back(
      {{{{0.8, 2e-8, 1}, {0.8, 0.5, 1}, {0.8, 1, 1}}}, {1, 2}, ParameterLaw::Linear});
  return chart.made;
}

TEST(PoleEnds, MakeTwoCornersOfOneThatBordersSweepToBesideThePole) {
  const TrimmedChart given = touching();
  const TrimmedChart made = with_straight_pole_ends(sector(), given, kPoleTolerance);

  ASSERT_EQ(made.borders.size(), 4u);
  ASSERT_EQ(made.corners.size(), 4u);
  EXPECT_EQ(made.borders[1].to, 2);
  EXPECT_EQ(made.borders[2].from, 3);
  EXPECT_EQ(made.corners[2], (Vec2{0.2, 0}));
  EXPECT_EQ(made.corners[3], (Vec2{0.8, 0}));
  const RegionBorder& pole = made.borders[3];
  EXPECT_TRUE(pole.is_point);
  EXPECT_FALSE(pole.reversed);
  EXPECT_EQ(pole.from, 2);
  EXPECT_EQ(pole.to, 3);
  EXPECT_EQ(point_at(pole.curve, 0), made.corners[2]);
  EXPECT_EQ(point_at(pole.curve, 1), made.corners[3]);
  for (int k = 0; k <= 20; ++k) {
    EXPECT_DOUBLE_EQ(point_at(made.borders[1].curve, 0.1 * k)[0], 0.2);
    EXPECT_DOUBLE_EQ(point_at(made.borders[2].curve, 0.1 * k)[0], 0.8);
  }
}

// Where the corner is farther from the pole, or the region on its other side, it stays one.
TEST(PoleEnds, LeaveCornersThatAreAtNoPole) {
  const TrimmedChart given = touching();
  EXPECT_EQ(with_straight_pole_ends(sector(), given, 5e-9).corners, given.corners);

  BezierSurface turned = sector();
  std::swap(turned.patches(0, 0).points(0, 0), turned.patches(0, 0).points(0, 1));
  std::swap(turned.patches(0, 0).points(1, 0), turned.patches(0, 0).points(1, 1));
  EXPECT_EQ(with_straight_pole_ends(turned, given, kPoleTolerance).corners, given.corners);

  TrimmedChart other = given;
  for (RegionBorder& border : other.borders) {
    border.reversed = true;
    std::swap(border.from, border.to);
  }
  EXPECT_EQ(with_straight_pole_ends(sector(), other, kPoleTolerance).corners, given.corners);
}

}  // namespace
}  // namespace blossom
