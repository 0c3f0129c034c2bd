// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/quintic_spline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/math/vec.h"

namespace blossom {
namespace {

QuinticJet<Vec2> on_circle(double r, double t) {
  const double c = r * std::cos(t), s = r * std::sin(t);
  return {{c, s}, {-s, c}, Vec2{-c, -s}};
}

// The largest distance from a circle, at even steps of its knots and uneven ones.
double off_circle(double r, const std::vector<double>& knots) {
  std::vector<QuinticJet<Vec2>> jets;
  for (const double t : knots) jets.push_back(on_circle(r, t));
  const Spline2 made = quintic_through(knots, jets);
  double off = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double t = at(made.domain(), i / 1000.0);
    off = std::max(off, norm(point_at(made, t) - on_circle(r, t).value));
  }
  return off;
}

TEST(QuinticThrough, IsOffACircleByTheSixthPowerOfItsAngles) {
  std::vector<double> even;
  for (int i = 0; i <= 16; ++i) even.push_back(0.25 * i);
  EXPECT_NEAR(off_circle(1e4, even) / (1e4 * std::pow(0.25, 6) / 46080), 1, 0.02);
  const double uneven = off_circle(1, {0, 0.1, 0.6, 0.8});
  EXPECT_NEAR(uneven / (std::pow(0.5, 6) / 46080), 1, 0.05);
}

TEST(QuinticThrough, IsTwiceDifferentiableAtItsKnots) {
  const std::vector<double> knots{0, 1, 1.5, 4};
  const std::vector<QuinticJet<Vec2>> jets{{{0, 1}, {2, 3}, Vec2{4, 5}},
                                           {{6, 7}, {8, 9}, Vec2{1, 2}},
                                           {{3, 4}, {5, 6}, Vec2{7, 8}},
                                           {{9, 1}, {2, 3}, Vec2{4, 5}}};
  const Spline2 made = quintic_through(knots, jets);
  constexpr double kStep = 1e-6;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    EXPECT_LE(norm(point_at(made, knots[i]) - jets[i].value), 1e-13);
    EXPECT_LE(norm(derivative_at(made, knots[i]) - jets[i].rate), 1e-12);
    for (const double side : {-1.0, 1.0}) {
      const double t = knots[i] + side * kStep;
      if (t < knots.front() || t > knots.back()) continue;
      const Vec2 bend = side / kStep * (derivative_at(made, t) - jets[i].rate);
      EXPECT_LE(norm(bend - *jets[i].bend), 1e-2);
    }
  }
}

// So a curve comes to a pole, where its image has no second derivative.
TEST(QuinticThrough, TakesQuarticsToEndsOfUnknownSecondDerivative) {
  const auto quartic = [](double t) {
    return QuinticJet<Vec2>{
        {t * t * t * t, t - t * t}, {4 * t * t * t, 1 - 2 * t}, Vec2{12 * t * t, -2}};
  };
  const std::vector<double> knots{-1, 0.5, 1, 3};
  std::vector<QuinticJet<Vec2>> jets;
  for (const double t : knots) jets.push_back(quartic(t));
  jets.front().bend = jets.back().bend = std::nullopt;
  const Spline2 made = quintic_through(knots, jets);
  for (int i = 0; i <= 100; ++i) {
    const double t = at(made.domain(), i / 100.0);
    EXPECT_LE(norm(point_at(made, t) - quartic(t).value), 1e-12);
  }
}

}  // namespace
}  // namespace blossom
