// SPDX-License-Identifier: LGPL-2.1-or-later
// Interpolated curves and surfaces: exact for quintics, within what they state for others.

#include "core/forms/spans/fitted_spans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace blossom {
namespace {

Vec3 quintic(double t) { return {t, t * t - 2 * std::pow(t, 5), 1 + std::pow(t, 3)}; }
Vec3 helix(double t) { return {std::cos(t), std::sin(t), 0.2 * t}; }

TEST(FittedSpans, QuinticIsOneSpanWithinRounding) {
  const CurveSpans found = fitted_spans(quintic, {-1, 1}, 1e-12);
  ASSERT_EQ(found.spans.size(), 1U);
  EXPECT_LT(found.error, 1e-13);
  EXPECT_EQ(point_at(found, -1), quintic(-1));
  EXPECT_EQ(point_at(found, 1), quintic(1));
}

TEST(FittedSpans, AreWithinTheirErrorAndMoreOfThemAreNearer) {
  const CurveSpans coarse = fitted_spans(helix, {0, 3, 9}, 1e-4);
  const CurveSpans fine = fitted_spans(helix, {0, 3, 9}, 1e-10);
  EXPECT_LT(coarse.spans.size(), fine.spans.size());
  for (const CurveSpans* found : {&coarse, &fine}) {
    validate(*found, "helix");
    double largest = 0;
    for (double t = 0; t <= 9; t += 0.003)
      largest = std::max(largest, distance(point_at(*found, t), helix(t)));
    EXPECT_LE(largest, found->error);
    EXPECT_GT(largest, 0.1 * found->error);
  }
  EXPECT_LE(coarse.error, 1e-4);
  EXPECT_LE(fine.error, 1e-10);
}

TEST(FittedSpans, ToleranceThatCannotBeMetIsReported) {
  const auto jump = [](double t) { return Vec3{t, t < 0.3 ? 0. : 1., 0}; };
  const CurveSpans found = fitted_spans(jump, {0, 1}, 1e-6);
  EXPECT_GT(found.error, 0.1);
  EXPECT_LT(found.spans.size(), 30U);
}

TEST(FittedSurface, IsWithinItsErrorAndHalvesWhereItErrs) {
  // Waves in u alone.
  const auto waves = [](double u, double v) { return Vec3{u, v, std::sin(5 * u) + v * v}; };
  const BezierSurface found = fitted_surface(waves, {0, 4}, {0, 1}, 1e-6);
  validate(found, "waves");
  EXPECT_LE(found.error, 1e-6);
  EXPECT_GT(found.patches.rows(), 4);
  EXPECT_EQ(found.patches.columns(), 1);
  for (double u = 0; u <= 4; u += 0.03)
    for (double v = 0; v <= 1; v += 0.1)
      EXPECT_LE(distance(point_at(found, {u, v}), waves(u, v)), found.error);
}

TEST(FittedSurface, NeighboursShareTheirBorderBitForBit) {
  const auto bowl = [](double u, double v) { return Vec3{u, v, std::exp(u) * std::cos(v)}; };
  const BezierSurface found = fitted_surface(bowl, {0, 1, 3}, {0, 2, 3}, 1e-2);
  const int degree = found.patches(0, 0).points.rows() - 1;
  for (int r = 1; r < found.patches.rows(); ++r)
    for (int c = 0; c < found.patches.columns(); ++c)
      for (int j = 0; j <= degree; ++j)
        EXPECT_EQ(found.patches(r, c).points(0, j), found.patches(r - 1, c).points(degree, j));
}

// A jump is not taken for what needs more spans, whatever else varies, and a narrow crest not for
// a jump.
TEST(FittedSurface, IsNotHalvedForAJump) {
  int values = 0;
  const auto step = [&](double s, double t) {
    ++values;
    return Vec3{9 * s, t, std::sin(3 * s) * t + (s + 0.2 * t < 0.7 ? 0 : 0.4)};
  };
  const BezierSurface fit = fitted_surface(step, {0, 1}, {0, 1}, 1e-8);
  EXPECT_GE(fit.error, 0.4);
  EXPECT_LE(fit.error, 1.0);
  EXPECT_LE(fit.patches.rows(), 8);
  EXPECT_LE(values, 20000);
  const auto crest = [](double s, double t) {
    return Vec3{s, t, 0.1 / (1 + std::pow(100 * (s - 0.7), 2))};
  };
  EXPECT_LE(fitted_surface(crest, {0, 1}, {0, 1}, 1e-6).error, 1e-6);
}

// Where there is no room for all, those go first that are off most.
TEST(FittedSurface, SpendsItsSpansWhereTheErrorIs) {
  const auto ridge = [](double s, double t) {
    const double x = 60 * (s - 0.7);
    return Vec3{s, t, 0.1 * std::sin(30 * s) + 0.02 / (1 + x * x)};
  };
  const BezierSurface fit = fitted_surface(ridge, {0, 1}, {0, 1}, 1e-16);
  EXPECT_GE(fit.patches.rows(), 90);
  EXPECT_LE(fit.patches.rows(), 96);
  EXPECT_LT(fit.error, 1e-9);
}

}  // namespace
}  // namespace blossom
