// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/math/series/taylor_series.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::Random;
using testing::seeded;
using testing::uniform;

TaylorPolynomial random_polynomial(Random& random, int degree, double size) {
  TaylorPolynomial p{};
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; i + j <= degree; ++j) p[taylor_index(i, j)] = uniform(random, -size, size);
  return p;
}

TEST(TaylorSeries, OfAProductHasTheTermsOfIt) {
  TaylorPolynomial x{}, y{};
  x[taylor_index(1, 0)] = 2;
  y[taylor_index(0, 1)] = 3;
  y[0] = 1;

  const TaylorSeries product = taylor_series(x) * taylor_series(y);  // 2 x + 6 x y

  TaylorPolynomial expected{};
  expected[taylor_index(1, 0)] = 2;
  expected[taylor_index(1, 1)] = 6;
  EXPECT_EQ(product.terms, expected);
  EXPECT_LT(product.tail(0), 1e-13);
}

class TaylorSeriesProperty : public ::testing::TestWithParam<int> {};

TEST_P(TaylorSeriesProperty, BoundsWhatAProductLeavesOut) {
  Random random = seeded(GetParam());
  const TaylorPolynomial f = random_polynomial(random, 5, 1), g = random_polynomial(random, 5, 1);
  const TaylorSeries product = taylor_series(f) * taylor_series(g);

  for (int k = 0; k < 20; ++k) {
    const double x = uniform(random, -1, 1), y = uniform(random, -1, 1);
    EXPECT_LE(std::abs(value(f, x, y) * value(g, x, y) - value(product.terms, x, y)),
              product.tail(0));
  }
}

TEST_P(TaylorSeriesProperty, BoundsWhatAReciprocalLeavesOut) {
  Random random = seeded(GetParam());
  TaylorPolynomial f = random_polynomial(random, 3, 0.05);
  f[0] = 1;
  bool exists = false;
  const TaylorSeries inverse = reciprocal(taylor_series(f), exists);

  ASSERT_TRUE(exists);
  for (int k = 0; k < 20; ++k) {
    const double x = uniform(random, -1, 1), y = uniform(random, -1, 1);
    EXPECT_LE(std::abs(1 / value(f, x, y) - value(inverse.terms, x, y)), inverse.tail(0));
  }
}

TEST_P(TaylorSeriesProperty, IsTurnedAndTakenAlongLinesExactly) {
  Random random = seeded(GetParam());
  const TaylorPolynomial p = random_polynomial(random, kTaylorDegree, 1);
  const auto random_vector = [&] { return Vec2{uniform(random, -1, 1), uniform(random, -1, 1)}; };
  const Vec2 a = random_vector(), b = random_vector(), at = random_vector();
  const TaylorPolynomial turned_p = turned(p, a, b);
  const Polynomial line = along_line(p, a, b);

  const Vec2 place = at[0] * a + at[1] * b, on_line = a + at[1] * b;
  EXPECT_NEAR(value(turned_p, at[0], at[1]), value(p, place[0], place[1]), 1e-11);
  EXPECT_NEAR(value(line, at[1]), value(p, on_line[0], on_line[1]), 1e-11);
  EXPECT_NEAR(value(along_y(p, at[0]), at[1]), value(p, at[0], at[1]), 1e-13);
  TaylorPolynomial x{}, y{};
  x[taylor_index(1, 0)] = a[0];
  x[taylor_index(0, 1)] = b[0];
  y[taylor_index(1, 0)] = a[1];
  y[taylor_index(0, 1)] = b[1];
  const TaylorSeries composed = TaylorPowers(x, y).compose(taylor_series(p));
  for (std::size_t i = 0; i < p.size(); ++i) EXPECT_NEAR(turned_p[i], composed.terms[i], 1e-12);
}

TEST_P(TaylorSeriesProperty, IsMovedExactly) {
  Random random = seeded(GetParam());
  const TaylorPolynomial p = random_polynomial(random, kTaylorDegree, 1);
  const Vec2 by{uniform(random, -1, 1), uniform(random, -1, 1)};
  const Vec2 at{uniform(random, -1, 1), uniform(random, -1, 1)};
  EXPECT_NEAR(value(moved(p, by), at[0], at[1]), value(p, at[0] + by[0], at[1] + by[1]), 1e-11);
}

// Coefficients small enough that |x|, |y| <= 1, without those below total degree `lowest`.
TaylorPolynomial small_polynomial(Random& random, int lowest) {
  TaylorPolynomial p = random_polynomial(random, kTaylorDegree, 0.03);
  std::fill_n(p.begin(), taylor_index(lowest, 0), 0.0);
  return p;
}

TEST_P(TaylorSeriesProperty, BoundsWhatACompositionLeavesOut) {
  Random random = seeded(GetParam());
  const TaylorPolynomial x = small_polynomial(random, 1), y = small_polynomial(random, 1);
  const TaylorSeries f = taylor_series(random_polynomial(random, kTaylorDegree, 1));
  const TaylorSeries composed = TaylorPowers(x, y).compose(f);

  for (int k = 0; k < 20; ++k) {
    const double s = uniform(random, -1, 1), t = uniform(random, -1, 1);
    const double expected = value(f.terms, value(x, s, t), value(y, s, t));
    EXPECT_LE(std::abs(value(composed.terms, s, t) - expected), composed.tail(0));
  }
}

TEST_P(TaylorSeriesProperty, SolvesForTheInverseOfABentMap) {
  Random random = seeded(GetParam());
  const TaylorPolynomial u = small_polynomial(random, 1), v = small_polynomial(random, 1);
  const TaylorPolynomial p = random_polynomial(random, kTaylorDegree, 1);
  TaylorPolynomial bent = p;
  std::fill_n(bent.begin(), taylor_index(2, 0), 0.0);
  const TaylorPowers powers(u, v, p, p);  // what p has below total degree 2 is left aside

  const TaylorSeries rest = powers.compose(taylor_series(bent));
  for (std::size_t i = 0; i < u.size(); ++i) {
    EXPECT_NEAR(powers.x().terms[i] + rest.terms[i], u[i], 1e-15);
    EXPECT_NEAR(powers.y().terms[i] + rest.terms[i], v[i], 1e-15);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, TaylorSeriesProperty, ::testing::Range(0, 30));

}  // namespace
}  // namespace blossom
