// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tracing/local_form.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "core/base/errors.h"
#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::seeded;
using testing::uniform;

double value_of(std::span<const double> form, double t) {
  std::vector<double> points(form.begin(), form.end());
  for (; points.size() > 1; points.pop_back())
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      points[i] = (1 - t) * points[i] + t * points[i + 1];
  return points.front();
}

TEST(LocalForm, OfALineIsTheFractionOfTheSpan) {
  const LocalForm found = local_form({2, 2.5, 3, 3.5, 4, 6}, ParameterLaw::Linear, {2, 4}, 5);

  EXPECT_TRUE(std::ranges::equal(found.points(), std::array{0.0, 0.25, 0.5, 0.75, 1.0, 2.0}));
  EXPECT_EQ(found.error, 0);
}

// A quarter turn from end to end: 0, the middle and 1 are known.
TEST(LocalForm, OfAWholeArcIsWithinItsStatedError) {
  const double end = std::numbers::pi / 2;
  std::array<double, 6> angles;
  for (std::size_t i = 0; i < 6; ++i) angles[i] = end * static_cast<double>(i) / 5;

  const LocalForm found = local_form(angles, ParameterLaw::Angle, {0, end}, 8);

  EXPECT_LE(found.error, 1e-3);
  for (const auto& [t, q] : {std::pair{0.0, 0.0}, {0.5, 0.5}, {1.0, 1.0}})
    EXPECT_NEAR(value_of(found.points(), t), q, found.error + found.rounding);
}

// The angle is the middle's plus h x, so |q - 1/2| <= tan(1.2) / (2 k) within r = 1.2 / h - 1 of
// the piece; the radius that is found is up to a fifth smaller.
TEST(LocalForm, StatesCauchysBound) {
  const Interval span{0, 1};
  const double h = 0.05;
  std::array<double, 6> angles;
  for (std::size_t i = 0; i < 6; ++i) angles[i] = 0.5 + 2 * h * (0.4 * static_cast<double>(i) - 1);

  for (int n = 5; n <= kAngleDegree; ++n) {
    const auto bound = [&](double r) {
      return std::tan(1.2) / (2 * std::tan(0.25)) * std::pow(r, -(n + 1)) * std::pow(2.0, -n);
    };
    const double found = local_form(angles, ParameterLaw::Angle, span, n).error;
    EXPECT_GE(found, bound(1.2 / h - 1));
    EXPECT_LE(found, 1.1 * bound(1.2 / h / 1.25 - 1));
  }
}

TEST(LocalForm, RejectsDegreesItHasNoRuleFor) {
  const std::array<double, 6> angles{0, 0.1, 0.2, 0.3, 0.4, 0.5};
  EXPECT_THROW(local_form(angles, ParameterLaw::Angle, {0, 1}, 4), InvalidInput);
  EXPECT_THROW(local_form(angles, ParameterLaw::Angle, {0, 1}, 9), InvalidInput);
}

class LocalFormProperty : public ::testing::TestWithParam<int> {};

// Pieces of all lengths in spans of all lengths; the bound is no more than a thousand times off
// where it is above rounding.
TEST_P(LocalFormProperty, IsWithinItsStatedError) {
  auto random = seeded(GetParam());
  const double width = uniform(random, 0.1, 3.0), from = uniform(random, -3, 3);
  const Interval span{from, from + width};
  const double length = width * std::pow(10.0, uniform(random, -2, 0));
  const double start = from + uniform(random, 0, width - length);
  std::array<double, 6> angles;
  for (std::size_t i = 0; i < 6; ++i)
    angles[i] = start + length * (static_cast<double>(i) / 5 + uniform(random, -0.02, 0.02));

  for (int degree = 5; degree <= kAngleDegree; ++degree) {
    const LocalForm found = local_form(angles, ParameterLaw::Angle, span, degree);
    for (int i = 0; i <= 100; ++i) {
      const double t = i / 100.0;
      const double angle = value_of(angles, t);
      const double q = local_parameter(ParameterLaw::Angle, span, angle);
      EXPECT_LE(std::abs(value_of(found.points(), t) - q), found.error + found.rounding);
    }
    EXPECT_LE(found.rounding, 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, LocalFormProperty, ::testing::Range(0, 60));

}  // namespace
}  // namespace blossom
