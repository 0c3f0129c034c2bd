// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/math/binomial.h"

#include <gtest/gtest.h>

#include "core/math/detail/bernstein.h"
#include "core/math/detail/scaled_bernstein.h"
#include "core/math/whole_binomial.h"
#include "tests/support/exact.h"

namespace blossom {
namespace {

using testing::Rational;

TEST(Binomial, HasHandValues) {
  EXPECT_EQ(binomial(0, 0), 1);
  EXPECT_EQ(binomial(5, 2), 10);
  EXPECT_EQ(binomial(25, 12), 5200300);
  EXPECT_EQ(binomial(50, 25), 126410606437752);
}

TEST(Binomial, IsZeroOutsideTheTriangle) {
  EXPECT_EQ(binomial(4, -1), 0);
  EXPECT_EQ(binomial(4, 5), 0);
}

TEST(Binomial, IsExactInDoubleUpToTheHighestIndex) {
  for (int n = 0; n <= kMaxBinomial; ++n) {
    Rational value = 1;
    for (int k = 0; k <= n; ++k) {
      EXPECT_EQ(Rational(binomial(n, k)), value) << n << ", " << k;
      value = value * (n - k) / (k + 1);
    }
  }
}

TEST(WholeBinomial, IsExactUpToTheHighestIndex) {
  for (int n = 0; n <= kMaxWholeBinomial; ++n) {
    Rational value = 1;
    for (int k = 0; k <= n; ++k) {
      EXPECT_EQ(Rational(whole_binomial(n, k)), value) << n << ", " << k;
      EXPECT_EQ(detail::binomial_as<Rational>(n, k), value) << n << ", " << k;
      EXPECT_EQ(detail::binomial_as<double>(n, k), value.convert_to<double>()) << n << ", " << k;
      value = value * (n - k) / (k + 1);
    }
  }
  EXPECT_EQ(whole_binomial(4, 5), 0u);
}

TEST(MixedPowers, AreProductsOfPowersByHand) {
  // (1 - t)^(2 - i) t^i as plain coefficients in Bernstein form: one of them each.
  const std::vector<double> a{1, 0}, b{0, 1};
  const Grid<double> powers = detail::mixed_powers(std::span(a), std::span(b), 2);
  for (int i = 0; i <= 2; ++i)
    for (int k = 0; k <= 2; ++k) EXPECT_EQ(powers(i, k), i == k ? 1 : 0);
  EXPECT_EQ(detail::mixed_powers(std::span(a), std::span(b), 0), Grid<double>(1, 1, 1.0));
}

TEST(Trinomial, CountsWaysToDealThreeHands) {
  EXPECT_EQ(trinomial(4, 2, 1), 12);
  EXPECT_EQ(trinomial(6, 2, 2), 90);
}

TEST(Bernstein, SumsToOneExactly) {
  const Rational t = Rational(3) / 7;
  for (int n = 0; n <= 25; ++n) {
    Rational sum = 0;
    for (const Rational& value : detail::bernstein(n, t)) sum += value;
    EXPECT_EQ(sum, 1);
  }
}

TEST(Bernstein, IsThePowerFormula) {
  const Rational t = Rational(2) / 5;
  const std::vector<Rational> values = detail::bernstein(4, t);
  const auto p = detail::powers(t, 4), q = detail::powers<Rational>(1 - t, 4);
  for (int i = 0; i <= 4; ++i)
    EXPECT_EQ(values[detail::index(i)],
              Rational(binomial(4, i)) * p[detail::index(i)] * q[detail::index(4 - i)]);
}

TEST(Powers, TakesZeroToTheZeroAsOne) {
  EXPECT_EQ(detail::powers(0.0, 2), (std::vector<double>{1, 0, 0}));
}

}  // namespace
}  // namespace blossom
