// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/math/series/taylor_curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::Random;
using testing::seeded;
using testing::uniform;

TEST(TaylorCurve, KnowsTheRangeOfACoordinate) {
  const TaylorCurve curve({0.5, 0.25}, {1, 0, 0, 2});
  TaylorPolynomial x{}, y{};
  x[taylor_index(1, 0)] = 1;
  y[taylor_index(0, 1)] = 1;
  EXPECT_NEAR(curve.along(x).range().low, 0.25, 1e-15);
  EXPECT_NEAR(curve.along(x).range().high, 0.75, 1e-15);
  EXPECT_NEAR(curve.along(y).range().low, -1, 1e-15);
  EXPECT_NEAR(curve.along(y).range().high, 3, 1e-15);
}

class TaylorCurveProperty : public ::testing::TestWithParam<int> {};

TEST_P(TaylorCurveProperty, BoundsHoldAndAreHardlyWiderThanTheValues) {
  Random random = seeded(GetParam());
  const auto number = [&](double size) { return uniform(random, -size, size); };
  const std::array x{number(0.5), number(0.5)};
  const std::array y{number(0.4), number(0.3), number(0.1), number(0.1)};
  TaylorPolynomial p{};
  for (double& c : p) c = number(1);
  const PolynomialRange range = TaylorCurve(x, y).along(p).range();
  double low = 1e300, high = -1e300;
  for (int i = 0; i <= 200; ++i) {
    const double t = -1 + i / 100.0;
    const double at = value(p, x[0] + x[1] * t, y[0] + t * (y[1] + t * (y[2] + t * y[3])));
    low = std::min(low, at);
    high = std::max(high, at);
  }
  const double rounding = 1e-13;
  EXPECT_LE(range.low, low + rounding);
  EXPECT_GE(range.high, high - rounding);
  EXPECT_LE(range.high - range.low, 1.2 * (high - low) + rounding);
}

TEST_P(TaylorCurveProperty, PartsAreThePolynomialBeforeAndAfterTheCut) {
  Random random = seeded(GetParam());
  const auto number = [&](double size) { return uniform(random, -size, size); };
  TaylorPolynomial p{};
  for (double& c : p) c = number(1);
  const TaylorCurve curve({number(0.5), number(0.5)}, {number(0.4), number(0.3), number(0.1), 0});
  const AlongCurve whole = curve.along(p);
  const double t = uniform(random, 0.1, 0.9);
  const auto parts = whole.parts(t);
  const auto last = AlongCurve::kDegree;
  EXPECT_EQ(parts[0].coefficients[0], whole.coefficients[0]);
  EXPECT_EQ(parts[1].coefficients[last], whole.coefficients[last]);
  // Blossoms at t: each coefficient of a part is a value of the whole's polar form.
  const auto polar = [&](std::size_t at_t, std::size_t at_end) {
    std::vector<double> c(whole.coefficients.begin(), whole.coefficients.begin() + last + 1);
    for (std::size_t n = last, k = 0; n > 0; --n, ++k) {
      const double x = k < at_t ? t : k < at_t + at_end ? 1 : 0;
      for (std::size_t i = 0; i < n; ++i) c[i] = (1 - x) * c[i] + x * c[i + 1];
    }
    return c[0];
  };
  for (std::size_t i = 0; i <= last; ++i) {
    EXPECT_NEAR(parts[0].coefficients[i], polar(i, 0), 1e-13);
    EXPECT_NEAR(parts[1].coefficients[i], polar(last - i, i), 1e-13);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, TaylorCurveProperty, ::testing::Range(0, 24));

}  // namespace
}  // namespace blossom
