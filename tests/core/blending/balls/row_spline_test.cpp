// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/balls/detail/row_spline.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/errors.h"

namespace blossom {
namespace {

const std::vector<double> kKnots{0, 0.4, 1, 1.5};

// Samples of two functions at 8 places of every span.
template <class F, class G>
RowSamples samples_of(const F& f, const G& g) {
  RowSamples samples;
  for (std::size_t i = 0; i + 1 < kKnots.size(); ++i)
    for (int k = 0; k < 8; ++k) {
      const double t = kKnots[i] + (kKnots[i + 1] - kKnots[i]) * (k + 0.5) / 8;
      samples.parameters.push_back(t);
      samples.values.push_back(f(t));
      samples.values.push_back(g(t));
    }
  samples.ends = {std::vector{f(0), g(0)}, std::vector{f(1.5), g(1.5)}};
  return samples;
}

double quintic(double t) { return 1 + t * (2 - t * t * (1 - 0.3 * t * t)); }
double quintic_rate(double t) { return 2 - 3 * t * t + 1.5 * t * t * t * t; }

TEST(RowSpline, ReproducesPolynomials) {
  for (const int inner : {1, 4, 5}) {
    const RowSpline spline = least_squares_rows(
        kKnots, {6, inner, 1, 6}, samples_of(quintic, [](double t) { return 3 - t; }));
    std::array<double, 2> value, rate;
    for (const auto& [span, t] : {std::pair{0, 0.1}, std::pair{1, 0.4}, std::pair{2, 1.45}}) {
      evaluate(spline, static_cast<std::size_t>(span), t, value, rate);
      EXPECT_NEAR(value[0], quintic(t), 1e-14);
      EXPECT_NEAR(rate[0], quintic_rate(t), 1e-12);
      EXPECT_NEAR(value[1], 3 - t, 1e-14);
      EXPECT_NEAR(rate[1], -1, 1e-13);
    }
  }
}

TEST(RowSpline, TakesEndsAndRatesExactly) {
  RowSamples samples =
      samples_of([](double t) { return std::sin(3 * t); }, [](double t) { return std::exp(t); });
  samples.rates = {std::vector{3.0, 1.0}, std::vector{3 * std::cos(4.5), std::exp(1.5)}};
  const RowSpline spline = least_squares_rows(kKnots, {6, 1, 1, 6}, samples);
  std::array<double, 2> value, rate;
  evaluate(spline, 0, 0, value, rate);
  EXPECT_EQ(value[0], 0);
  EXPECT_NEAR(rate[0], 3, 1e-14);
  EXPECT_NEAR(rate[1], 1, 1e-14);
  evaluate(spline, 2, 1.5, value, rate);
  EXPECT_DOUBLE_EQ(value[1], std::exp(1.5));
  EXPECT_NEAR(rate[0], 3 * std::cos(4.5), 1e-13);
  evaluate(spline, 1, 0.7, value, rate);
  EXPECT_NEAR(value[0], std::sin(2.1), 2e-3);
}

TEST(RowSpline, HasTheBezierPointsOfItsSpans) {
  const RowSpline spline = least_squares_rows(
      kKnots, {6, 4, 1, 6},
      samples_of([](double t) { return std::sin(3 * t); }, [](double t) { return t * t; }));
  std::array<double, 2> value, rate;
  for (std::size_t span = 0; span < 3; ++span) {
    std::vector<double> c = bezier_points(spline, span);
    const double t = 0.3;
    evaluate(spline, span, kKnots[span] + t * (kKnots[span + 1] - kKnots[span]), value, rate);
    for (std::size_t count = 5; count > 0; --count)
      for (std::size_t i = 0; i < 2 * count; ++i) c[i] = (1 - t) * c[i] + t * c[i + 2];
    EXPECT_NEAR(c[0], value[0], 1e-14);
    EXPECT_NEAR(c[1], value[1], 1e-14);
  }
}

TEST(RowSpline, RefusesKnotsWithoutSamples) {
  RowSamples samples;
  samples.ends = {std::vector{0.0}, std::vector{1.0}};
  EXPECT_THROW(least_squares_rows(kKnots, {6, 1, 1, 6}, samples), InvalidInput);
}

}  // namespace
}  // namespace blossom
