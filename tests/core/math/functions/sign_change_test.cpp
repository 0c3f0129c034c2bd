// SPDX-License-Identifier: LGPL-2.1-or-later
// Changes of sign against functions whose zeros are known, easy and hard for secants.
#include "core/math/functions/sign_change.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace blossom {
namespace {

constexpr double kWidth = 0x1p-51;
constexpr int kHalvings = 52;         // of an interval of length 2 until it is that short
constexpr double kSpacing = 0x1p-53;  // of doubles from 1/2 to 1

struct Counted {
  SignChange ends;
  int steps = 0;
};

Counted counted(const std::function<double(double)>& f, double below, double above,
                double width = kWidth) {
  Counted result;
  const auto count = [&](double x) {
    ++result.steps;
    return f(x);
  };
  result.ends = narrowed(count, {below, above}, f(below), f(above), width);
  return result;
}

class SignChangeAt : public ::testing::TestWithParam<double> {};

TEST_P(SignChangeAt, IsNarrowedFromBothSidesByFewSteps) {
  const double zero = GetParam();
  const auto f = [&](double x) { return std::exp(x) - std::exp(zero); };

  for (const bool turned : {false, true}) {
    const auto g = [&](double x) { return turned ? f(-x) : f(x); };
    const Counted found = turned ? counted(g, 1, -1) : counted(g, -1, 1);

    EXPECT_LE(std::abs(found.ends.above - found.ends.below), kWidth);
    EXPECT_NEAR(found.ends.below, turned ? -zero : zero, 4 * kWidth);
    EXPECT_LT(g(found.ends.below), 0);
    EXPECT_GE(g(found.ends.above), 0);
    EXPECT_LT(found.steps, 14);
  }
}

INSTANTIATE_TEST_SUITE_P(Zeros, SignChangeAt,
                         ::testing::Values(-0.999, -0.5, -1e-9, 0.0, 0.25, 0.7, 1 - 1e-12));

TEST(SignChange, TakesAStepMoreThanHalvingAtWorst) {
  const auto jump = [](double x) { return x < 0.3141 ? -1e-12 : 1e6; };
  const auto flat = [](double x) { return std::pow(x - 0.2, 9); };

  for (const auto& f : {std::function<double(double)>(jump), std::function<double(double)>(flat)}) {
    const Counted found = counted(f, -1, 1);

    EXPECT_LE(std::abs(found.ends.above - found.ends.below), kWidth);
    EXPECT_LE(found.steps, kHalvings + 2);
  }
}

// Beside the zero there is no more than a double left between an end and where a step may lead.
TEST(SignChange, IsNarrowedToTwoSpacingsOfDoubles) {
  for (int i = 0; i < 2000; ++i) {
    const double zero = 0.5 + 0.5 * std::fmod(0.61803398874989 * i, 1.0);
    const double bend = 0.1 + std::fmod(0.754877666 * i, 1.0);
    const auto f = [&](double x) { return std::expm1(bend * (x - zero)) / bend; };

    const Counted found = counted(f, -1, 1, 2 * kSpacing);

    EXPECT_LE(std::abs(found.ends.above - found.ends.below), 2 * kSpacing) << zero << ' ' << bend;
    EXPECT_LE(found.steps, 14);
  }
}

TEST(SignChange, OfAnEndThatIsTheZeroIsNarrowedToo) {
  const auto f = [](double x) { return x - 1; };

  const Counted found = counted(f, -1, 1);

  EXPECT_EQ(found.ends.above, 1);
  EXPECT_NEAR(found.ends.below, 1, kWidth);
}

}  // namespace
}  // namespace blossom
