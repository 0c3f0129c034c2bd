// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tracing/image_series.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "core/forms/evaluation.h"
#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::Random;
using testing::seeded;
using testing::uniform;

double value(const PowerSeries<double>& f, double x) {
  double sum = 0;
  for (std::size_t k = kSeriesDegree + 1; k-- > 0;) sum = sum * x + f.terms[k];
  return sum;
}

RationalBezierPatch random_patch(Random& random, int n, int m, double weights) {
  RationalBezierPatch patch{Grid<Vec4>(n + 1, m + 1)};
  for (Vec4& p : patch.points.values()) {
    const double w = 1 + weights * uniform(random, -1, 1);
    p = {w * uniform(random, 4, 6), w * uniform(random, -1, 1), w * uniform(random, -1, 1), w};
  }
  return patch;
}

TEST(PowerSeries, IsTheForm) {
  auto random = seeded(7);
  for (const int degree : {1, 2, 5, 8}) {
    std::vector<double> points;
    for (int i = 0; i <= degree; ++i) points.push_back(uniform(random, 2, 3));
    const PowerSeries<double> series = power_series(points);
    for (int i = 0; i <= 16; ++i) {
      const double t = i / 16.0;
      std::vector<double> p = points;
      for (std::size_t level = p.size() - 1; level > 0; --level)
        for (std::size_t k = 0; k < level; ++k) p[k] = (1 - t) * p[k] + t * p[k + 1];
      EXPECT_NEAR(value(series, 2 * t - 1), p[0], power_rounding(degree) + 1e-15);
    }
  }
}

TEST(PowerSeries, BezierPointsGiveTheTermsBack) {
  PowerSeries<Vec3> series;
  for (std::size_t k = 0; k <= kSeriesDegree; ++k)
    series.terms[k] = {std::cos(static_cast<double>(k)), 1 / (1 + static_cast<double>(k)),
                       k == 3 ? 1.0 : 0.0};
  for (const std::size_t degree : {kSeriesDegree, kShortSeriesDegree}) {
    const SeriesForm form = bezier_form(series, degree);
    const BezierCurve curve{{form.points().begin(), form.points().end()}};
    ASSERT_EQ(curve.points.size(), degree + 1);
    for (int i = 0; i <= 16; ++i) {
      std::vector<Vec3> p = curve.points;
      const double t = i / 16.0, x = 2 * t - 1;
      for (std::size_t level = p.size() - 1; level > 0; --level)
        for (std::size_t k = 0; k < level; ++k) p[k] = (1 - t) * p[k] + t * p[k + 1];
      Vec3 sum{};
      for (std::size_t k = degree + 1; k-- > 0;) sum = sum * x + series.terms[k];
      EXPECT_LE(distance(sum, p[0]), 1e-13);
    }
  }
}

TEST(PowerSeries, ReciprocalIsThatUpToItsRest) {
  PowerSeries<double> f;
  f.terms = {2, 0.2, -0.1, 0.05};
  PowerSeries<double> one = product(f, reciprocal(f));
  one.terms[0] -= 1;
  EXPECT_LE(absolute_sum(one), 1e-15);
  EXPECT_LE(one.rest, 1e-6);
  for (const double x : {-1.0, -0.3, 0.4, 1.0})
    EXPECT_NEAR(value(reciprocal(f), x), 1 / value(f, x), one.rest);
}

// The bounds hold for curves of any length, and are small for short ones.
TEST(ImageSeries, HoldsTheImageWithinItsRest) {
  auto random = seeded(8);
  for (const auto& [n, m] : {std::pair{1, 1}, {3, 3}, {2, 7}, {12, 9}, {25, 1}})
    for (const double weights : {0.0, 0.4})
      for (const double reach : {0.5, 0.1, 0.01}) {
        const RationalBezierPatch patch = random_patch(random, n, m, weights);
        std::vector<double> u, v;
        for (int i = 0; i <= 5; ++i) {
          const double s = i / 5.0 - 0.5;
          u.push_back(0.5 + reach * s * (1 + 0.3 * uniform(random, -1, 1)));
          v.push_back(0.5 + reach * s * (s - 0.7));
        }
        const PowerSeries<double> in_u = power_series(u), in_v = power_series(v);
        const Vec3 origin = point_at(patch, 0.5, 0.5);
        for (const std::size_t degree : {kSeriesDegree, kShortSeriesDegree}) {
          const ImageSeries found = image_series(patch, origin, in_u, in_v, 1e-11, degree);
          for (int i = 0; i <= 20; ++i) {
            const double x = i / 10.0 - 1;
            Vec4 h{};
            for (std::size_t k = degree + 1; k-- > 0;) h = h * x + found.image.terms[k];
            const Vec3 exact = point_at(patch, value(in_u, x), value(in_v, x)) - origin;
            const double w = h[3];
            for (int k = 0; k < 3; ++k)
              EXPECT_LE(std::abs(h[k] - w * exact[k]),
                        found.image.rest[k] + found.image.rest[3] * std::abs(exact[k]) +
                            2 * max_norm(found.rounding) + 1e-13)
                  << n << " " << m << " " << reach << " " << degree;
          }
          if (reach < 0.05 && n + m < 10) {
            EXPECT_LE(max_norm(found.image.rest), degree == kSeriesDegree ? 1e-10 : 1e-8);
          }
        }
      }
}

TEST(ImageSeries, BoundsSlopes) {
  auto random = seeded(9);
  const RationalBezierPatch patch = random_patch(random, 4, 6, 0.0);
  const std::vector<double> u{0.2, 0.25, 0.3, 0.3, 0.2, 0.1}, v{0.8, 0.7, 0.6, 0.7, 0.7, 0.75};
  const PowerSeries<double> in_u = power_series(u), in_v = power_series(v);
  const ImageSeries found = image_series(patch, {}, in_u, in_v, 1e-11);
  for (int i = 0; i <= 20; ++i) {
    const double x = i / 10.0 - 1;
    const PatchJet jet = jet_at(patch, value(in_u, x), value(in_v, x), 1);
    for (int k = 0; k < 3; ++k) {
      EXPECT_LE(std::abs(jet.u[k]), found.slope_u[k] * (1 + 1e-12));
      EXPECT_LE(std::abs(jet.v[k]), found.slope_v[k] * (1 + 1e-12));
    }
  }
}

}  // namespace
}  // namespace blossom
