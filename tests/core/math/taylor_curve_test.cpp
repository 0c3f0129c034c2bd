// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/math/taylor_curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

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
  EXPECT_NEAR(curve.range(x).low, 0.25, 1e-15);
  EXPECT_NEAR(curve.range(x).high, 0.75, 1e-15);
  EXPECT_NEAR(curve.range(y).low, -1, 1e-15);
  EXPECT_NEAR(curve.range(y).high, 3, 1e-15);
}

class TaylorCurveProperty : public ::testing::TestWithParam<int> {};

TEST_P(TaylorCurveProperty, BoundsHoldAndAreHardlyWiderThanTheValues) {
  Random random = seeded(GetParam());
  const auto number = [&](double size) { return uniform(random, -size, size); };
  const std::array x{number(0.5), number(0.5)};
  const std::array y{number(0.4), number(0.3), number(0.1), number(0.1)};
  TaylorPolynomial p{};
  for (double& c : p) c = number(1);
  const PolynomialRange range = TaylorCurve(x, y).range(p);
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

INSTANTIATE_TEST_SUITE_P(Seeds, TaylorCurveProperty, ::testing::Range(0, 24));

}  // namespace
}  // namespace blossom
