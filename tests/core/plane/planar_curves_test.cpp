// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/plane/planar_curves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "core/base/errors.h"
#include "core/plane/planar_crossings.h"
#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::Random;
using testing::seeded;
using testing::uniform;

constexpr double kTolerance = 1e-7;

// y = x^2 over [-1, 1].
PlanarCurve parabola() {
  return {{{{{{-1, 1, 1}, {0, -1, 1}, {1, 1, 1}}}, {-1, 1}, ParameterLaw::Linear}}};
}

// The unit circle in four quarters; the parameter is the angle.
PlanarCurve circle(const Vec2& centre, double radius) {
  const double h = std::numbers::pi / 2, w = std::sqrt(0.5);
  PlanarCurve curve;
  for (int k = 0; k < 4; ++k) {
    const Vec2 from{std::cos(k * h), std::sin(k * h)},
        to{std::cos((k + 1) * h), std::sin((k + 1) * h)};
    const Vec2 corner = from + to;
    curve.spans.push_back(
        {{{{from[0], from[1], 1}, {w * corner[0], w * corner[1], w}, {to[0], to[1], 1}}},
         {k * h, (k + 1) * h},
         ParameterLaw::Angle});
  }
  return transformed(curve, {radius, radius}, centre);
}

TEST(PlanarCurves, SplineAndItsSpansAreTheSameCurve) {
  const Spline2 spline{
      3, {0, 1, 3, 4}, {4, 1, 2, 4}, {{0, 0}, {1, 2}, {2, -1}, {3, 3}, {4, 0}, {5, 1}, {6, -2}}};
  const PlanarCurve curve = planar_curve(spline);
  ASSERT_EQ(curve.spans.size(), 3u);
  for (double t = 0; t <= 4; t += 0.125) {
    EXPECT_LE(distance(point_at(curve, t), point_at(spline, t)), 1e-14) << "at " << t;
    EXPECT_LE(distance(jet_at(curve, t).first, derivative_at(spline, t)), 1e-13) << "at " << t;
  }
}

TEST(PlanarCurves, RejectASplineWhoseKnotsDoNotFit) {
  EXPECT_THROW(planar_curve({3, {0, 1}, {4, 3}, {{0, 0}, {1, 0}, {2, 0}, {3, 0}}}), InvalidInput);
}

TEST(PlanarCurves, CircleIsParametrisedByItsAngle) {
  const PlanarCurve curve = circle({1, 2}, 3);
  for (double t = 0.05; t < 6.28; t += 0.37) {
    const PlanarJet jet = jet_at(curve, t);
    EXPECT_LE(distance(jet.point, Vec2{1 + 3 * std::cos(t), 2 + 3 * std::sin(t)}), 1e-14);
    EXPECT_LE(distance(jet.first, Vec2{-3 * std::sin(t), 3 * std::cos(t)}), 1e-13);
    EXPECT_LE(distance(jet.second, Vec2{-3 * std::cos(t), -3 * std::sin(t)}), 1e-12);
  }
}

TEST(PlanarCurves, PiecesOfARangeRunInItsDirection) {
  const PlanarCurve curve = circle({0, 0}, 1);
  const auto pieces = bezier_pieces(curve, {3.0, 0.25});
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_LE(distance(projected(pieces.front().points.front()), point_at(curve, 3.0)), 1e-14);
  EXPECT_LE(distance(projected(pieces.back().points.back()), point_at(curve, 0.25)), 1e-14);
  for (const PlanarBezier& piece : pieces) EXPECT_NEAR(norm(jet_at(piece, 0.3).point), 1, 1e-14);
}

TEST(PlanarCurves, PieceThatEndsARoundingBeyondASpanHasNoSliver) {
  const double h = std::numbers::pi / 2;
  EXPECT_EQ(bezier_pieces(circle({0, 0}, 1), {0.1, std::nextafter(h, 2)}).size(), 1u);
  EXPECT_EQ(bezier_pieces(circle({0, 0}, 1), {std::nextafter(h, 0), 2}).size(), 1u);
}

TEST(PlanarCurves, NearestPointOfACircleLiesOnTheRay) {
  const PlanarFoot foot = nearest(circle({0, 0}, 2), {3 * std::cos(1.0), 3 * std::sin(1.0)});
  EXPECT_NEAR(foot.parameter, 1.0, 1e-10);
  EXPECT_NEAR(foot.distance, 1.0, 1e-12);
}

TEST(PlanarCrossings, LineMeetsParabolaInTwoHandComputedPoints) {
  const auto found = crossings(parabola(), planar_line({-1, 0.25}, {1, 0.25}, {0, 2}), kTolerance);
  ASSERT_EQ(found.points.size(), 2u);
  EXPECT_NEAR(found.points[0].a, -0.5, 1e-14);
  EXPECT_NEAR(found.points[0].b, 0.5, 1e-14);
  EXPECT_NEAR(found.points[1].a, 0.5, 1e-14);
  EXPECT_FALSE(found.points[0].tangential || found.points[1].tangential);
  EXPECT_TRUE(found.complete);
}

TEST(PlanarCrossings, TwoCirclesMeetAtAnglesOfTheChordFormula) {
  // Radii 1, centres 1 apart: cos(angle) = 1/2.
  const auto found = crossings(circle({0, 0}, 1), circle({1, 0}, 1), kTolerance);
  ASSERT_EQ(found.points.size(), 2u);
  EXPECT_NEAR(found.points[0].a, std::numbers::pi / 3, 1e-13);
  EXPECT_NEAR(found.points[1].a, 5 * std::numbers::pi / 3, 1e-13);
  EXPECT_NEAR(found.points[0].b, 2 * std::numbers::pi / 3, 1e-13);
}

TEST(PlanarCrossings, CrossingAtASpanBorderIsFoundOnce) {
  const auto found = crossings(circle({0, 0}, 1), planar_line({0, 0}, {0, 2}, {0, 1}), kTolerance);
  ASSERT_EQ(found.points.size(), 1u);
  EXPECT_NEAR(found.points[0].a, std::numbers::pi / 2, 1e-13);
}

TEST(PlanarCrossings, TouchOfParabolaAndItsTangentIsReportedAsTangential) {
  const auto found = crossings(parabola(), planar_line({-1, 0}, {1, 0}, {0, 1}), kTolerance);
  ASSERT_EQ(found.points.size(), 1u);
  EXPECT_TRUE(found.points[0].tangential);
  EXPECT_NEAR(found.points[0].a, 0, 1e-4);
  EXPECT_TRUE(found.overlaps.empty());
}

// y = x^4 - s^4 keeps within the tolerance of the x-axis between its two crossings with it.
TEST(PlanarCrossings, ContactOfTheFourthOrderIsBothCrossingsInIt) {
  const double s = 0.0062, below = std::pow(s, 4);
  ASSERT_LT(below, kTolerance);
  PlanarCurve quartic{{{{{}}, {-1, 1}, ParameterLaw::Linear}}};
  for (int k = 0; k <= 4; ++k)
    quartic.spans[0].curve.points.push_back({-1 + 0.5 * k, (k % 2 == 0 ? 1 : -1) - below, 1});
  const PlanarCurve axis = planar_line({-1, 0}, {1, 0}, {-1, 1});
  for (const bool exchanged : {false, true}) {
    const auto found =
        exchanged ? crossings(axis, quartic, kTolerance) : crossings(quartic, axis, kTolerance);
    EXPECT_TRUE(found.overlaps.empty());
    ASSERT_EQ(found.points.size(), 2u);
    EXPECT_NEAR(found.points[0].a, -s, 1e-7);
    EXPECT_NEAR(found.points[0].b, -s, 1e-7);
    EXPECT_NEAR(found.points[1].a, s, 1e-7);
  }
}

TEST(PlanarCrossings, NearTouchAboveTheToleranceIsNoContact) {
  const auto found =
      crossings(parabola(), planar_line({-1, -3e-7}, {1, -3e-7}, {0, 1}), kTolerance);
  EXPECT_TRUE(found.points.empty());
  EXPECT_TRUE(found.overlaps.empty());
}

// The graph of x^3 + x^2 / 3 - x / 2 over [0, size] with `spans` spans, each point of the control
// polygon up to `noise` away. Inner knots lie `shift` of a span off their even places.
PlanarCurve noisy_cubic(double size, int spans, double shift, double noise, int seed) {
  Random random = seeded(seed);
  Spline2 spline;
  spline.degree = 3;
  std::vector<double> knots(3, 0.0);
  for (int i = 0; i <= spans; ++i) {
    const bool inner = i > 0 && i < spans;
    spline.knots.push_back(size * (i + (inner ? shift : 0)) / spans);
    spline.multiplicities.push_back(inner ? 1 : 4);
    knots.push_back(spline.knots.back());
  }
  knots.insert(knots.end(), 3, size);
  for (std::size_t i = 1; i + 3 < knots.size();
       ++i) {  // the blossom at three knots that follow each other
    const double x = knots[i], y = knots[i + 1], z = knots[i + 2], sum = x + y + z;
    spline.points.push_back(
        {sum / 3 + uniform(random, -0.3, 0.3) * noise,
         x * y * z + (x * y + y * z + z * x) / 9 - sum / 6 + uniform(random, -1, 1) * noise});
  }
  return planar_curve(spline);
}

TEST(PlanarCrossings, CurvesSideBySideAreOneRunHoweverTheGapVaries) {
  for (const double size : {0.01, 1.0})
    for (const int spans : {3, 6, 20})
      for (const double noise : {1e-8, 6e-8})
        for (int seed = 0; seed < 6; ++seed) {
          const PlanarCurve a = noisy_cubic(size, spans, 0, noise, seed);
          const PlanarCurve b = noisy_cubic(size, spans + 2, 0.3, noise, seed + 100);
          for (const bool exchanged : {false, true}) {
            const PlanarCrossings found = exchanged ? crossings(b, a, 2e-7) : crossings(a, b, 2e-7);
            SCOPED_TRACE(::testing::Message()
                         << size << ", " << spans << " spans, " << noise << ", " << seed);
            ASSERT_EQ(found.overlaps.size(), 1U);
            EXPECT_EQ(found.points.size(), 2U);
            EXPECT_NEAR(found.overlaps[0].a.from, 0, 1e-6);
            EXPECT_NEAR(found.overlaps[0].a.to, size, 1e-6);
            EXPECT_NEAR(found.overlaps[0].b.from, 0, 1e-6);
            EXPECT_NEAR(found.overlaps[0].b.to, size, 1e-6);
          }
        }
}

// A polygon by its x.
PlanarCurve polygon(const std::vector<Vec2>& corners) {
  Spline2 spline;
  spline.degree = 1;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    spline.knots.push_back(corners[i][0]);
    spline.multiplicities.push_back(i == 0 || i + 1 == corners.size() ? 2 : 1);
  }
  spline.points = corners;
  return planar_curve(spline);
}

TEST(PlanarCrossings, CurvesThatPartForALittleWhileAreTwoRuns) {
  const PlanarCurve line = polygon({{0, 0}, {1, 0}});
  const PlanarCurve nearly = polygon({{0, 1e-8}, {0.3, -1e-8}, {0.6, 1e-8}, {1, 0}});
  for (const double height : {0.3, 1e-3, 1e-6})
    for (const double x : {0.3, 0.503, 0.51}) {
      SCOPED_TRACE(height);
      SCOPED_TRACE(x);
      const PlanarCurve spike =
          polygon({{0, 0}, {x, 0}, {x + 0.002, height}, {x + 0.004, 0}, {1, 0}});
      for (const PlanarCurve& other : {line, nearly})
        for (const bool exchanged : {false, true}) {
          const PlanarCrossings found =
              exchanged ? crossings(spike, other, kTolerance) : crossings(other, spike, kTolerance);
          ASSERT_GE(found.overlaps.size(), 2U);
          for (const auto& run : found.overlaps)
            EXPECT_TRUE(run.a.to < x + 0.001 || run.a.from > x + 0.003);
        }
    }
}

TEST(PlanarCrossings, CommonRunIsAnOverlapWithBothRanges) {
  const auto found = crossings(planar_line({0, 0}, {4, 0}, {0, 4}),
                               planar_line({3, 0}, {-1, 0}, {0, 1}), kTolerance);
  ASSERT_EQ(found.overlaps.size(), 1u);
  EXPECT_NEAR(found.overlaps[0].a.from, 0, 1e-6);
  EXPECT_NEAR(found.overlaps[0].a.to, 3, 1e-6);
  EXPECT_NEAR(found.overlaps[0].b.from, 0.75, 1e-6);
  EXPECT_NEAR(found.overlaps[0].b.to, 0, 1e-6);
}

TEST(PlanarCrossings, EndWithinToleranceOfTheOtherCurveCounts) {
  const auto found = crossings(planar_line({0, 0}, {1, -5e-8}, {0, 1}),
                               planar_line({1, -1}, {1, 1}, {0, 2}), kTolerance);
  ASSERT_EQ(found.points.size(), 1u);
  EXPECT_EQ(found.points[0].a, 1);
  const auto short_of = crossings(planar_line({0, 0}, {1 - 5e-8, 0}, {0, 1}),
                                  planar_line({1, -1}, {1, 1}, {0, 2}), kTolerance);
  ASSERT_EQ(short_of.points.size(), 1u);
  EXPECT_EQ(short_of.points[0].a, 1);
  EXPECT_NEAR(short_of.points[0].b, 1, 1e-7);
}

TEST(PlanarCrossings, SwappedCurvesGiveTheSamePoints) {
  const Spline2 wave{
      3, {0, 1, 2, 3}, {4, 1, 1, 4}, {{-2, 0}, {-1, 3}, {0, -3}, {0.5, 3}, {1, -3}, {2, 0.5}}};
  const PlanarCurve a = planar_curve(wave), b = circle({0, 0}, 0.9);
  const auto forth = crossings(a, b, kTolerance), back = crossings(b, a, kTolerance);
  ASSERT_GE(forth.points.size(), 2u);
  ASSERT_EQ(forth.points.size(), back.points.size());
  EXPECT_EQ(forth.points.size() % 2, 0u);
  for (const PlanarCrossing& point : forth.points) {
    EXPECT_NEAR(norm(point_at(a, point.a)), 0.9, 1e-12);
    EXPECT_LE(distance(point_at(a, point.a), point_at(b, point.b)), 1e-12);
  }
}

TEST(PlanarCrossings, StopWithinTheirBudgetAndSayThatTheyDid) {
  EXPECT_FALSE(crossings(circle({0, 0}, 1), circle({1e-4, 0}, 1), 1e-12, 50).complete);
}

TEST(PlanarCrossings, RejectAToleranceThatIsNotPositive) {
  EXPECT_THROW(crossings(parabola(), parabola(), 0), InvalidInput);
}

// A leg of a corner at the origin, in spans of a few thousandths of the tolerance near it, as fits
// have them whose other chart bends sharply there.
PlanarCurve finely_fitted_leg(double direction) {
  PlanarCurve leg;
  double from = 0, step = 2e-10;
  for (int k = 0; k < 3000; ++k) {
    const double to = from + step;
    leg.spans.push_back({{{{from, direction * from, 1}, {to, direction * to, 1}}}, {from, to}});
    from = to;
    if (k > 2000) step *= 1.02;
  }
  return leg;
}

TEST(PlanarCrossings, LegsOfACornerInSpansFarBelowTheToleranceMeetOnceWithinTheBudget) {
  const PlanarCurve up = finely_fitted_leg(1), down = finely_fitted_leg(-1);
  const PlanarCrossings found = crossings(up, down, 1e-6, 20'000);
  EXPECT_TRUE(found.complete);
  EXPECT_TRUE(found.overlaps.empty());
  ASSERT_EQ(found.points.size(), 1u);
  EXPECT_EQ(found.points[0].a, 0);
  EXPECT_EQ(found.points[0].b, 0);
}

TEST(PlanarCrossings, SpansFarBelowTheToleranceAreCrossedWhereTheirCurveIs) {
  const PlanarCurve leg = finely_fitted_leg(1);
  const double at = leg.spans[1000].place.from;
  const PlanarCrossings found =
      crossings(leg, planar_line({at - 1, at + 1}, {at + 1, at - 1}, {0, 2}), 1e-9);
  EXPECT_TRUE(found.complete);
  ASSERT_EQ(found.points.size(), 1u);
  EXPECT_NEAR(found.points[0].a, at, 1e-10);
  EXPECT_NEAR(found.points[0].b, 1, 1e-10);
}

// A fitted curve that passes a span of rounding's width has such spans itself.
TEST(PlanarCrossings, TinySpansAtTheEndAreNoRunAlongTheOtherCurve) {
  constexpr double kLow = -1.2e-8, kStep = 6e-10;
  PlanarCurve a;
  a.spans.push_back({{{{0.2, 0.5, 1}, {0.7, 0, 1}}}, {0, 1}, ParameterLaw::Linear});
  Vec2 at{0.7, 0};
  for (int k = 0; k < 16; ++k) {
    PlanarBezier curve{{{at[0], at[1], 1}}};
    for (const double noise : {1.5e-9, 1.2e-9, 0.9e-9, -0.7e-9, 0.5e-9}) {
      at = {at[0] + kStep, (k + 1) * kLow / 16 + (k < 15 ? noise : 0)};
      curve.points.push_back({at[0], at[1], 1});
    }
    a.spans.push_back({curve, {1 + k * 1e-8, 1 + (k + 1) * 1e-8}, ParameterLaw::Linear});
  }
  PlanarCurve b;
  b.spans.push_back({{{{0, kLow, 1}, {1, kLow, 1}}}, {0, 1}, ParameterLaw::Linear});
  const PlanarCrossings found = crossings(a, b, 1e-7);
  ASSERT_FALSE(found.points.empty());
  for (const PlanarCrossing& point : found.points) EXPECT_NEAR(point.b, 0.7, 1e-6);
  for (const PlanarOverlap& run : found.overlaps) {
    EXPECT_NEAR(run.b.from, 0.7, 1e-6);
    EXPECT_NEAR(run.b.to, 0.7, 1e-6);
  }
}

// Halves of a circle of a torus in its chart, of which rounding makes lines at an angle of 1e-14:
// these cross far from where the first one begins.
TEST(PlanarCrossings, OfLinesThatGoOnFromEachOtherAreTheirCommonEndAlone) {
  const PlanarCurve on = planar_line({1608.4954386379732, 3452.5224933169029},
                                     {3216.9908772759482, 3452.5224933169138}, {0, 1});
  const PlanarCurve before = planar_line({4.5474735088646412e-13, 3452.5224933169097},
                                         {1608.4954386379718, 3452.5224933169097}, {0, 1});
  for (const bool swapped : {false, true}) {
    const auto found =
        swapped ? crossings(before, on, 1e-7).points : crossings(on, before, 1e-7).points;
    ASSERT_FALSE(found.empty());
    for (const PlanarCrossing& crossing : found) {
      EXPECT_EQ(crossing.a, swapped ? 1 : 0);
      EXPECT_EQ(crossing.b, swapped ? 0 : 1);
    }
  }
}

}  // namespace
}  // namespace blossom
