// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/papers/q_bernstein.h"
#include "core/math/index.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

#include "core/base/errors.h"
#include "core/math/detail/bernstein.h"
#include "tests/core/papers/q_cases.h"

namespace blossom {
namespace {

using testing::exact_curve;
using testing::exact_points;
using testing::ExactCurve;
using testing::ExactInterval;
using testing::ExactPoint2;
using testing::ExactPoint3;
using testing::ExactQ;
using testing::fraction;
using testing::nonzero_fraction;
using testing::power;
using testing::Random;
using testing::Rational;
using testing::seeded;

TEST(QBernstein, OfDegreeTwoIsThatByHand) {
  // q = (1/2, 1), [0, 1]: (1 - x)(1 - x / 2), 3/2 x (1 - x), x^2.
  EXPECT_EQ(q_bernstein(2, 0.5, Interval{0, 1}, QParameters{0.5, 1}),
            (std::vector<double>{0.375, 0.375, 0.25}));
}

TEST(QBernstein, OfTheUnitIntervalIsThePostQuantumBasis) {
  // Mursaleen and others: [n,k] p^(-n(n-1)/2) p^(k(k-1)/2) x^k prod_{i<n-k} (p^i - q^i x).
  const ExactQ q{Rational(2, 3), Rational(5, 4)};
  const Rational x(3, 7);
  for (int n = 0; n <= 6; ++n)
    for (int k = 0; k <= n; ++k) {
      Rational value = q_binomials(n, q)[index(k)] * power(x, k) *
                       power(q.q2, k * (k - 1) / 2 - n * (n - 1) / 2);
      for (int i = 0; i < n - k; ++i) value *= power(q.q2, i) - power(q.q1, i) * x;
      EXPECT_EQ(q_bernstein(n, x, ExactInterval{Rational(0), Rational(1)}, q)[index(k)], value);
    }
}

// Random admissible parameters and intervals, degree 1..6.
class QBernsteinProperty : public ::testing::TestWithParam<int> {
 protected:
  int degree() const { return 1 + GetParam() % 6; }
  Random random_ = seeded(GetParam() + 100);
  ExactCurve curve_ = exact_curve(random_, degree());
  Rational x_ = fraction(random_);
  const ExactInterval& interval() const { return curve_.interval; }
  const ExactQ& q() const { return curve_.q; }
  std::vector<Rational> basis(const Rational& x) const {
    return q_bernstein(degree(), x, interval(), q());
  }
};

TEST_P(QBernsteinProperty, IsTheQuotientOfProducts) {
  const auto& [a, b] = interval();
  const int n = degree();
  Rational divisor(1);
  for (int i = 0; i < n; ++i) divisor *= power(q().q1, i) * a - power(q().q2, i) * b;
  for (int k = 0; k <= n; ++k) {
    Rational value = q_binomials(n, q())[index(k)] / divisor;
    for (int i = 0; i < k; ++i) value *= power(q().q1, i) * a - power(q().q2, i) * x_;
    for (int i = 0; i < n - k; ++i) value *= power(q().q1, i) * x_ - power(q().q2, i) * b;
    EXPECT_EQ(basis(x_)[index(k)], value);
  }
}

TEST_P(QBernsteinProperty, SumsToOne) {  // Proposition 4.1
  const auto values = basis(x_);
  EXPECT_EQ(std::accumulate(values.begin(), values.end(), Rational(0)), 1);
}

TEST_P(QBernsteinProperty, ReproducesTheParameterWithAPlus) {  // Proposition 4.3, corrected
  const auto& [a, b] = interval();
  const int n = degree();
  const Rational all = q_integer(n, q());
  if (all == 0) return;
  Rational sum(0), printed(0);
  for (int k = 0; k <= n; ++k) {
    const Rational share = power(q().q2, n - k) * q_integer(k, q()) / all * (b - a);
    sum += (a + share) * basis(x_)[index(k)];
    printed += (a - share) * basis(x_)[index(k)];
  }
  EXPECT_EQ(sum, x_);
  EXPECT_EQ(printed, 2 * a - x_);
}

TEST_P(QBernsteinProperty, BothRecurrencesGiveIt) {  // (3.5) and (3.6)
  for (const QRecurrence recurrence : {QRecurrence::Forward, QRecurrence::Backward})
    EXPECT_EQ(q_bernstein_by(recurrence, degree(), x_, interval(), q()), basis(x_));
}

TEST_P(QBernsteinProperty, IsScaleInvariant) {  // (3.7)
  const Rational w = nonzero_fraction(random_);
  const ExactInterval scaled{w * interval().from, w * interval().to};
  EXPECT_EQ(q_bernstein(degree(), Rational(w * x_), scaled, q()), basis(x_));
}

TEST_P(QBernsteinProperty, DependsOnTheRatioAlone) {
  const Rational w = nonzero_fraction(random_);
  EXPECT_EQ(q_bernstein(degree(), x_, interval(), ExactQ{w * q().q1, w * q().q2}), basis(x_));
}

TEST_P(QBernsteinProperty, IsClassicalForEqualParameters) {
  const auto& [a, b] = interval();
  const Rational w = nonzero_fraction(random_), s = (x_ - a) / (b - a);
  EXPECT_EQ(q_bernstein(degree(), x_, interval(), ExactQ{w, w}), detail::bernstein(degree(), s));
}

TEST_P(QBernsteinProperty, IsAUnitVectorAtTheEnds) {  // Proposition 4.4
  std::vector<Rational> first(index(degree() + 1), Rational(0)), last = first;
  first.front() = 1;
  last.back() = 1;
  EXPECT_EQ(basis(interval().from), first);
  EXPECT_EQ(basis(interval().to), last);
}

// Theorem 3.1: for every m the polynomial is sum_k P_{m,k} B~_k^{n,m}.
TEST_P(QBernsteinProperty, PartialBasesLeadFromTheDiagonalToTheCurve) {
  const int n = degree();
  const MonomialCurveOf<ExactPoint3> polynomial{exact_points(random_, n)};
  const ExactPoint3 value = testing::homogeneous_value(polynomial.coefficients, x_, Rational(1));
  const auto pair = [&](int i, const Rational& x) {
    return ExactPoint2{power(q().q1, i) * x, power(q().q2, i)};
  };
  for (int m = 0; m <= n; ++m) {
    const auto partial = q_partial_bernstein(n, m, x_, interval(), q());
    ExactPoint3 sum{};
    for (int k = 0; k <= m; ++k) {
      std::vector<ExactPoint2> arguments;
      for (int i = n - 1; i >= m; --i) arguments.push_back(pair(i, x_));
      for (int i = n - 1; i >= n - m + k; --i) arguments.push_back(pair(i, interval().from));
      for (int i = k - 1; i >= 0; --i) arguments.push_back(pair(i, interval().to));
      sum += q_blossom_at(polynomial, q(), arguments) * partial[index(k)];
    }
    EXPECT_EQ(sum, value) << "m = " << m;
  }
}

TEST_P(QBernsteinProperty, SatisfiesMarsdensIdentity) {  // Theorem 3.8, corrected
  const Rational t = fraction(random_);
  const auto terms = q_marsden_terms(degree(), t, x_, interval(), q());
  EXPECT_EQ(std::accumulate(terms.begin(), terms.end(), Rational(0)),
            q_marsden_product(degree(), t, x_, interval(), q()));
}

INSTANTIATE_TEST_SUITE_P(Seeds, QBernsteinProperty, ::testing::Range(0, 24));

TEST(QBernstein, MarsdensIdentityFailsWithThePrintedDenominator) {
  const ExactQ q{Rational(2), Rational(3)};
  const ExactInterval interval{Rational(1), Rational(5)};
  const Rational t(2), x(4), product(6);
  const auto terms = q_marsden_terms(2, t, x, interval, q);
  Rational printed(0);  // [n,k] at 1/q1, 1/q2 is (q1 q2)^(-k(n-k)) [n,k]
  for (int k = 0; k <= 2; ++k) printed += terms[index(k)] * power(product, -k * (2 - k));
  EXPECT_NE(printed, q_marsden_product(2, t, x, interval, q));
}

TEST(QBernstein, ChangesUnderTranslationUnlessTheParametersAreEqual) {
  const ExactInterval unit{Rational(0), Rational(1)}, moved{Rational(1), Rational(2)};
  const Rational half(1, 2), moved_half(3, 2);
  const ExactQ different{Rational(1), Rational(2)}, equal{Rational(2), Rational(2)};
  EXPECT_NE(q_bernstein(2, half, unit, different), q_bernstein(2, moved_half, moved, different));
  EXPECT_EQ(q_bernstein(2, half, unit, equal), q_bernstein(2, moved_half, moved, equal));
}

TEST(QBernstein, IsNotNegativeForSafeParameters) {
  for (int seed = 0; seed < 60; ++seed) {
    auto random = seeded(seed);
    const int n = 1 + seed % 6;
    const ExactCurve curve = testing::safe_curve(random, n);
    const auto& [a, b] = curve.interval;
    ASSERT_EQ(q_basis_obstacle(n, curve.interval, curve.q), "");
    for (int i = 0; i <= 8; ++i) {
      const Rational x = a + (b - a) * i / 8;
      for (const Rational& value : q_bernstein(n, x, curve.interval, curve.q)) EXPECT_GE(value, 0);
    }
  }
}

TEST(QBernstein, ChangesItsSignElsewhere) {
  // Ratio 2 on [0, 1]: 1 - 2 x is a factor of B_0.
  EXPECT_LT(q_bernstein(2, 0.75, Interval{0, 1}, QParameters{2, 1})[0], 0);
}

TEST(QBernstein, RefusesWhatHasNoBasis) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(q_bernstein(2, 0.5, Interval{0.5, 1}, QParameters{2, 1}), InvalidInput);
  EXPECT_THROW(q_bernstein(2, nan, Interval{0, 1}, QParameters{}), InvalidInput);
  EXPECT_THROW(q_bernstein(2, 0.5, Interval{0, nan}, QParameters{}), InvalidInput);
  EXPECT_THROW(q_partial_bernstein(2, 3, 0.5, Interval{0, 1}, QParameters{}), InvalidInput);
  EXPECT_THROW(q_bernstein_by(QRecurrence::Forward, 26, 0.5, Interval{}, QParameters{}),
               InvalidInput);
  EXPECT_THROW(q_marsden_terms(1, 0.5, 0.5, Interval{0, 1}, QParameters{0, 1}), InvalidInput);
  EXPECT_THROW(q_marsden_product(1, nan, 0.5, Interval{0, 1}, QParameters{}), InvalidInput);
}

}  // namespace
}  // namespace blossom
