// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/topology/chart_projector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/base/work_limit.h"

namespace blossom {
namespace {

using std::numbers::pi;

constexpr double kTolerance = 1e-7;

// A tube of radius 2 and height 3, which counts how often it is searched: a little off, so that
// Newton's method has to do the rest.
struct Tube {
  int searches = 0;

  ProjectedSurface surface() {
    ProjectedSurface made;
    made.jet = [](const Vec2& uv) {
      const double c = std::cos(uv[0]), s = std::sin(uv[0]);
      return SurfaceJet{{2 * c, 2 * s, uv[1]}, {-2 * s, 2 * c, 0}, {0, 0, 1}};
    };
    made.search = [this](const Vec3& p) {
      ++searches;
      const double angle = std::atan2(p[1], p[0]);
      return Vec2{(angle < 0 ? angle + 2 * pi : angle) + 1e-4, std::clamp(p[2], 0.0, 3.0)};
    };
    made.low = {0, 0};
    made.high = {2 * pi, 3};
    made.period = {2 * pi, 0};
    return made;
  }
};

Vec3 around(double radius, double angle, double height) {
  return {radius * std::cos(angle), radius * std::sin(angle), height};
}

TEST(ChartProjector, FindsTheFootOfAPointOffTheSurface) {
  Tube tube;
  const ChartProjector feet(tube.surface(), kTolerance);
  const Vec2 uv = feet.foot(around(2.5, 0.7, 1), {});
  EXPECT_NEAR(uv[0], 0.7, 1e-6);
  EXPECT_NEAR(uv[1], 1, 1e-12);
  EXPECT_NEAR(feet.gap(around(2.5, 0.7, 1), uv), 0.5, 1e-12);
}

TEST(ChartProjector, SearchesOnlyForPointsThatAreNotOnTheSurfaceBesideThePlace) {
  Tube tube;
  const ChartProjector feet(tube.surface(), kTolerance);
  EXPECT_NEAR(feet.foot(around(2, 0.7, 1), Vec2{0.5, 1.2})[0], 0.7, 1e-9);
  EXPECT_EQ(tube.searches, 0);
  EXPECT_NEAR(feet.foot(around(2.1, 0.7, 1), Vec2{0.5, 1.2})[0], 0.7, 1e-6);
  EXPECT_EQ(tube.searches, 1);
}

TEST(ChartProjector, StaysInTheTurnOfThePlace) {
  Tube tube;
  const ChartProjector feet(tube.surface(), kTolerance);
  for (const double turn : {-2 * pi, 0.0, 2 * pi})
    for (const double radius : {2.0, 2.1})
      EXPECT_NEAR(feet.foot(around(radius, 0.7, 1), Vec2{turn + 1, 1})[0], turn + 0.7, 1e-6);
}

TEST(ChartProjector, PutsAPointOfASeamOnTheSideOfThePlace) {
  Tube tube;
  ProjectedSurface closed = tube.surface();
  closed.period = {};
  closed.closed = {2 * pi, 0};
  const ChartProjector feet(closed, kTolerance);
  EXPECT_EQ(feet.foot({2, 0, 1}, Vec2{6, 1})[0], 2 * pi);
  EXPECT_NEAR(feet.foot({2, 0, 1}, Vec2{0.3, 1})[0], 0, 1e-12);
}

TEST(ChartProjector, SharpensNothingThatAFormulaGives) {
  Tube tube;
  ProjectedSurface exact = tube.surface();
  exact.exact = true;
  const ChartProjector feet(exact, kTolerance);
  const double found = 0.7001;  // as the tube searches
  EXPECT_DOUBLE_EQ(feet.foot(around(2, 0.7, 1), {})[0], found);
  EXPECT_DOUBLE_EQ(feet.foot(around(2, 0.7, 1), Vec2{0.7 - 2 * pi, 1})[0], found - 2 * pi);
}

TEST(ChartProjector, MeasuresHowFarFeetAreFromBordersThatAreNoSeams) {
  Tube tube;
  const ChartProjector feet(tube.surface(), kTolerance);
  EXPECT_DOUBLE_EQ(feet.clearance(around(2, 0, 1), {0, 1}), 1);
  EXPECT_DOUBLE_EQ(feet.clearance(around(2, 0, 2.75), {0, 2.75}), 0.25);
  EXPECT_NEAR(feet.clearance(around(2, 0, 3.5), {0, 3}), -0.5, 1e-12);
}

TEST(ChartProjector, TellsTheSideOfThePoint) {
  Tube tube;
  const ChartProjector feet(tube.surface(), kTolerance);
  EXPECT_NEAR(feet.height(around(2.5, 0.7, 1)), 0.5, 1e-9);
  EXPECT_NEAR(feet.height(around(1.5, 0.7, 1)), -0.5, 1e-9);
}

TEST(ChartProjector, KnowsThePoleWithinTolerance) {
  Tube tube;
  ProjectedSurface with_pole = tube.surface();
  with_pole.poles = {{{0, 0, 5}, 1, 5}};
  const ChartProjector feet(with_pole, kTolerance);
  EXPECT_EQ(feet.pole_at({0, 0, 5 + 0.5 * kTolerance}), feet.poles().data());
  EXPECT_EQ(feet.pole_at({0, 0, 5 + 2 * kTolerance}), nullptr);
}

TEST(ChartProjector, EndsWhenItsLimitIsReached) {
  Tube tube;
  const std::function<bool()> cancelled = [] { return true; };
  const WorkLimit limit(0, cancelled);
  PolledLimit polled(limit);
  const ChartProjector feet(tube.surface(), kTolerance, &polled);
  EXPECT_THROW(feet.foot({2, 0, 1}, Vec2{0, 1}), LimitReached);
}

TEST(ChartStep, IsTheStepThatComesNearestAndNoneWithoutATangentPlane) {
  const SurfaceJet at{{0, 0, 0}, {2, 0, 0}, {1, 4, 0}};
  const Vec2 step = chart_step(at, {3, 4, 7});
  EXPECT_DOUBLE_EQ(step[0], 1);
  EXPECT_DOUBLE_EQ(step[1], 1);
  EXPECT_EQ(chart_step({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}}, {3, 4, 7}), Vec2{});
}

// Beside the pole of a ball, where a step in space of the size of the ball is one of thousands of
// turns: of a surface that can be asked beyond its period only some turns away.
TEST(ChartProjector, NeverGoesManyTurnsRoundAPole) {
  ProjectedSurface ball;
  ball.jet = [](const Vec2& uv) {
    EXPECT_LT(std::abs(uv[0]), 100);
    const double a = std::cos(uv[0]), b = std::sin(uv[0]), c = std::cos(uv[1]), s = std::sin(uv[1]);
    return SurfaceJet{{a * c, b * c, s}, {-b * c, a * c, 0}, {-a * s, -b * s, c}};
  };
  ball.search = [](const Vec3&) { return Vec2{0, 0.5 * pi - 1e-6}; };
  ball.rough = true;
  ball.low = {0, -0.5 * pi};
  ball.high = {2 * pi, 0.5 * pi};
  ball.period = {2 * pi, 0};
  ChartProjector(ball, kTolerance).foot({0, 1, 0}, {});
}

}  // namespace
}  // namespace blossom
