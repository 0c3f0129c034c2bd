// SPDX-License-Identifier: LGPL-2.1-or-later
// Sets that are at the same distance all over a surface or along a curve.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "core/distance.h"
#include "tests/support/shapes.h"
#include "tests/support/solids.h"

namespace blossom {
namespace {

void expect_equal_distance(const DistanceResult& found, double expected) {
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_LE(found.lower, expected * (1 + 1e-15) + 1e-15);
  EXPECT_GE(found.upper, expected * (1 - 1e-14) - 1e-15);
  // All coordinates here sum to less than 10.
  EXPECT_LE(found.upper - found.lower,
            std::max(kDistanceAccuracy * expected, 10 * kDistanceResolution));
}

TEST(EqualDistances, OfBallsAboutOneCentreIsKnownAtOnce) {
  const DistanceOperand inner = measured(testing::unit_sphere());
  const DistanceOperand outer = measured(testing::revolved_circle(0, 2, -std::numbers::pi / 2, 2));
  for (const bool turned : {false, true}) {
    const DistanceResult found =
        turned ? least_distance(outer, inner) : least_distance(inner, outer);
    expect_equal_distance(found, 1);
    EXPECT_LE(found.pairs, 10'000);
  }
}

// About the z axis, over a range of z.
BezierSurface tube(double radius, double low, double high) {
  BezierSurface surface = testing::revolved_circle(0, 1, -std::numbers::pi / 2, 2);
  surface.v_knots = {0, 1};
  surface.v_law = ParameterLaw::Linear;
  const Grid<RationalBezierPatch> quarters = surface.patches;
  surface.patches = Grid<RationalBezierPatch>(quarters.rows(), 1);
  for (int i = 0; i < quarters.rows(); ++i) {
    const Grid<Vec4>& ball = quarters(i, 0).points;
    Grid<Vec4> net(ball.rows(), 2);
    for (int k = 0; k < ball.rows(); ++k)
      for (int end = 0; end < 2; ++end) {
        const Vec4& rim = ball(k, ball.columns() - 1);  // the equator
        net(k, end) = {radius * rim[0], radius * rim[1], rim[3] * (end == 0 ? low : high), rim[3]};
      }
    surface.patches(i, 0).points = net;
  }
  return surface;
}

TEST(EqualDistances, OfTubesAboutOneAxisIsKnownAtOnce) {
  const DistanceOperand shaft = measured(tube(1, -1, 2)), bore = measured(tube(1.25, 0, 3));
  const DistanceResult found = least_distance(shaft, bore);
  expect_equal_distance(found, 0.25);
  EXPECT_LE(found.pairs, 10'000);
  const DistanceResult ball = least_distance(measured(testing::unit_sphere()), bore);
  expect_equal_distance(ball, 0.25);
  EXPECT_LE(ball.pairs, 20'000);
}

// Of the level square of this half side, what is off the z axis by more than the radius.
DistanceOperand bored_square(double half, double radius, long& asked) {
  const BezierSurface square = testing::quadrilateral({-half, -half, 0}, {-half, half, 0},
                                                      {half, -half, 0}, {half, half, 0});
  DistanceOperand plate{{}, {}, {square}};
  const BezierSurface bore = tube(radius, 0, 1);
  for (const RationalBezierPatch& quarter : bore.patches.values()) {
    RationalBezierCurve arc;
    for (int k = 0; k < quarter.points.rows(); ++k) arc.points.push_back(quarter.points(k, 0));
    plate.curves.push_back(arc);
  }
  plate.trims = [half, radius, &asked](int, const Vec2& low, const Vec2& high) {
    ++asked;
    double least = 0, most = 0;  // distances from the axis, squared
    for (int k = 0; k < 2; ++k) {
      const double from = half * (2 * low[k] - 1), to = half * (2 * high[k] - 1);
      const double near = std::clamp(0.0, from, to);
      least += near * near;
      most += std::max(from * from, to * to);
    }
    return most < radius * radius    ? TrimSide::Outside
           : least > radius * radius ? TrimSide::Inside
                                     : TrimSide::Mixed;
  };
  return plate;
}

TEST(EqualDistances, OfAPinInABoreAsksTheTrimsFewTimes) {
  long asked = 0;
  const DistanceOperand plate = bored_square(2, 0.2, asked), pin = measured(tube(0.195, -1, 1));
  for (const bool turned : {false, true}) {
    asked = 0;
    expect_equal_distance(turned ? least_distance(pin, plate) : least_distance(plate, pin), 0.005);
    EXPECT_LE(asked, 5000);
  }
}

TEST(EqualDistances, OfTubesAboutOneAxisAsksNothingOfTheirTrimsWhereBordersAreAsNear) {
  DistanceOperand shaft = measured(tube(1, -1, 2)), bore = measured(tube(1.25, 0, 3));
  long asked = 0;
  shaft.trims = bore.trims = [&](int, const Vec2&, const Vec2&) {
    ++asked;
    return TrimSide::Inside;
  };
  const DistanceResult found = least_distance(shaft, bore);
  expect_equal_distance(found, 0.25);
  EXPECT_LE(found.pairs, 10'000);
  EXPECT_LE(asked, 1000);
}

TEST(EqualDistances, OfTubesAboutOneCircleIsKnownAtOnce) {
  const DistanceOperand core = measured(testing::torus(2, 0.25)),
                        pipe = measured(testing::torus(2, 0.5));
  for (const bool turned : {false, true}) {
    const DistanceResult found = turned ? least_distance(pipe, core) : least_distance(core, pipe);
    expect_equal_distance(found, 0.25);
    EXPECT_LE(found.pairs, 20'000);
  }
}

}  // namespace
}  // namespace blossom
