// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/math/functions/quadrature.h"

#include <gtest/gtest.h>

#include <cmath>

namespace blossom {
namespace {

TEST(Quadrature, OneCellIsExactForPowersUpTo22) {
  for (int n = 0; n <= 22; ++n) {
    auto power = [n](double x) { return std::pow(x, n); };
    EXPECT_NEAR(quadrature::cell(power, 0, 1).value, 1.0 / (n + 1), 1e-15) << "power " << n;
  }
}

TEST(Quadrature, OneCellIsNotExactForPower24OnASymmetricInterval) {
  auto power = [](double x) { return std::pow(x, 24); };
  EXPECT_GT(std::abs(quadrature::cell(power, -1, 1).value - 2.0 / 25), 1e-12);
}

TEST(Quadrature, SwappedEndsChangeTheSign) {
  const auto f = [](double x) { return std::exp(x); };
  EXPECT_NEAR(integral(f, 1, 0, 1e-13).value, 1 - std::exp(1), 1e-14);
}

TEST(Quadrature, HalvesItsCellsTowardsAKink) {
  const auto f = [](double x) { return std::abs(x - 0.3); };
  const Integral found = integral(f, 0, 1, 1e-12);
  EXPECT_NEAR(found.value, 0.5 * (0.3 * 0.3 + 0.7 * 0.7), 1e-12);
  EXPECT_LE(found.error, 1e-12);
}

TEST(Integral, EndsSoonWhereTheFunctionIsNoisy) {
  long calls = 0;
  const auto noisy = [&](double x) {
    ++calls;
    // A smooth function with noise above what the tolerance asks for in a small cell.
    return 1 + 1e-12 * std::sin(1e9 * x);
  };

  EXPECT_NEAR(integral(noisy, 0, 1, 1e-13).value, 1, 1e-11);
  EXPECT_LT(calls, 1'000'000);
}

// Each half of a cell is as wrong as the whole, for its width.
TEST(Integral, EndsWhereNoCellIsEverFineEnough) {
  long calls = 0, halvings = 1000;
  const auto wild = [&](double x) {
    ++calls;
    return std::sin(1e20 * x);
  };
  const Integral found = integral(wild, 0, 1, 1e-16, halvings);
  EXPECT_EQ(halvings, 0);
  EXPECT_EQ(calls, 15 * 2001);
  EXPECT_GT(found.error, 1e-16);
}

}  // namespace
}  // namespace blossom
