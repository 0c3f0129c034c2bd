// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tracing/spline_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/errors.h"
#include "core/forms/spline.h"
#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::seeded;
using testing::uniform;

// sin and cos of k t in the coordinates, with two derivatives.
std::array<Vec7, 3> wave(double t) {
  std::array<Vec7, 3> jet;
  for (int k = 0; k < 7; ++k) {
    const double w = 0.5 * (k + 1);
    jet[0][k] = std::sin(w * t);
    jet[1][k] = w * std::cos(w * t);
    jet[2][k] = -w * w * std::sin(w * t);
  }
  return jet;
}

std::vector<QuinticPiece> wave_pieces(double end, int count) {
  std::vector<QuinticPiece> pieces;
  for (int i = 0; i < count; ++i) {
    const Interval place{end * i / count, end * (i + 1) / count};
    pieces.push_back({place, hermite_points(wave(place.from), wave(place.to), length(place))});
  }
  return pieces;
}

// One coordinate as a spline that the core evaluates.
Spline coordinates(const RunSpline& found) {
  Spline spline{kFitDegree, found.knots, std::vector<int>(found.knots.size(), 1), {}};
  spline.multiplicities.front() = spline.multiplicities.back() = kFitDegree + 1;
  for (const Vec7& p : found.poles) spline.points.push_back({p[0], p[3], p[6]});
  return spline;
}

TEST(HermitePoints, HaveTheValuesAndDerivativesOfBothEnds) {
  // t^5 on [0, 2]: its Bezier points are 0 but the last.
  const std::array<Vec2, 3> start{}, stop{Vec2{32, 0}, {80, 0}, {160, 0}};
  const auto points = hermite_points(start, stop, 2);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(points[i][0], 0, 1e-13);
  EXPECT_EQ(points[5][0], 32);
}

TEST(LeastSquaresSpline, OfOneSpanIsTheHermitePolynomial) {
  const auto pieces = wave_pieces(1, 1);
  const RunSpline found = least_squares_spline(pieces, {0, 1});
  ASSERT_EQ(found.poles.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_LE(max_norm(found.poles[i] - pieces[0].points[i]), 1e-14);
}

TEST(LeastSquaresSpline, ReproducesAQuintic) {
  auto random = seeded(3);
  QuinticPiece whole{{0, 4}, {}};
  for (Vec7& p : whole.points)
    for (int k = 0; k < 7; ++k) p[k] = uniform(random, -1, 1);

  const RunSpline found = least_squares_spline({whole}, {0, 0.3, 1, 1.1, 2.5, 3.2, 4});

  const Spline spline = coordinates(found);
  for (int i = 0; i <= 200; ++i) {
    const Vec7 x = value_at(whole.points, i / 200.0);
    EXPECT_LE(max_norm(point_at(spline, i / 50.0) - Vec3{x[0], x[3], x[6]}), 1e-13);
  }
}

TEST(LeastSquaresSpline, MeetsBothEndsInPositionTangentAndCurvature) {
  const RunSpline found = least_squares_spline(wave_pieces(3, 20), {0, 0.4, 1, 1.7, 2.2, 3});
  const Spline spline = coordinates(found);
  constexpr double h = 1e-4;
  for (const double end : {0.0, 3.0}) {
    const auto jet = wave(end);
    const auto picked = [&](std::size_t order) {
      return Vec3{jet[order][0], jet[order][3], jet[order][6]};
    };
    const double inside = end == 0 ? h : end - h;
    const Vec3 rate = derivative_at(spline, end);
    const Vec3 bend = (derivative_at(spline, inside) - rate) * (1 / (inside - end));
    EXPECT_LE(distance(point_at(spline, end), picked(0)), 1e-14);
    EXPECT_LE(distance(rate, picked(1)), 1e-12);
    EXPECT_LE(distance(bend, picked(2)), 5e-2);
  }
}

// Of order 6: halving all spans divides the error by 64, or nearly.
TEST(LeastSquaresSpline, ConvergesWithTheSixthPowerOfItsSpans) {
  const auto pieces = wave_pieces(4, 200);
  const auto error = [&](int spans) {
    std::vector<double> knots;
    for (int i = 0; i <= spans; ++i) knots.push_back(4.0 * i / spans);
    const Spline spline = coordinates(least_squares_spline(pieces, knots));
    double worst = 0;
    for (int i = 0; i <= 1000; ++i) {
      const double t = i / 250.0;
      const Vec7 x = wave(t)[0];
      worst = std::max(worst, distance(point_at(spline, t), {x[0], x[3], x[6]}));
    }
    return worst;
  };
  const double coarse = error(16), fine = error(32);
  EXPECT_LE(coarse, 1e-3);
  EXPECT_LE(fine, coarse / 32);
}

// The samples that are handed back are those of the spline.
TEST(LeastSquaresSpline, ReturnsItsValuesAtTheChecks) {
  const RunSpline found = least_squares_spline(wave_pieces(2, 8), {0, 0.5, 1.2, 2});
  const Spline spline = coordinates(found);
  ASSERT_EQ(found.values.size(), 3 * kJudgedChecks.size());
  for (std::size_t span = 0; span < 3; ++span)
    for (std::size_t k = 0; k < kJudgedChecks.size(); ++k) {
      const double t =
          at(Interval{found.knots[span], found.knots[span + 1]}, kFitChecks[kJudgedChecks[k]]);
      const Vec7& x = found.values[span * kJudgedChecks.size() + k];
      EXPECT_LE(distance(point_at(spline, t), {x[0], x[3], x[6]}), 1e-14);
    }
}

TEST(LeastSquaresSpline, RejectsWhatIsNoRun) {
  EXPECT_THROW(least_squares_spline({}, {0, 1}), InvalidInput);
  EXPECT_THROW(least_squares_spline(wave_pieces(1, 2), {0}), InvalidInput);
  EXPECT_THROW(least_squares_spline(wave_pieces(1, 2), {0, 0.5, 0.5, 1}), InvalidInput);
}

}  // namespace
}  // namespace blossom
