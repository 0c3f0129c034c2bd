// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/papers/q_numbers.h"
#include "core/math/index.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/base/errors.h"
#include "core/math/binomial.h"
#include "tests/core/papers/q_cases.h"

namespace blossom {
namespace {

using testing::ExactQ;
using testing::power;
using testing::Rational;
using testing::seeded;

// Lemma 2.3 by its left side: all choices of k of the factors i = 1..n.
Rational sum_over_choices(int n, int k, const ExactQ& q) {
  Rational sum(0);
  for (unsigned choice = 0; choice < (1u << n); ++choice) {
    Rational product(1);
    int chosen = 0;
    for (int i = 1; i <= n; ++i) {
      const bool first = (choice >> (i - 1)) & 1u;
      chosen += first ? 1 : 0;
      product *= power(first ? q.q1 : q.q2, n - i);
    }
    if (chosen == k) sum += product;
  }
  return sum;
}

TEST(QNumbers, OfTwoAndThreeAreThoseByHand) {
  const QParameters q{2, 3};
  EXPECT_EQ(q_integer(0, q), 0);
  EXPECT_EQ(q_integer(1, q), 1);
  EXPECT_EQ(q_integer(2, q), 5);          // 2 + 3
  EXPECT_EQ(q_integer(3, q), 4 + 6 + 9);  // 2^2 + 2 3 + 3^2
  EXPECT_EQ(q_factorial(3, q), 19 * 5);
  EXPECT_EQ(q_binomials(3, q), (std::vector<double>{1, 19, 19, 1}));
}

TEST(QNumbers, AreTheOrdinaryOnesTimesPowersForEqualParameters) {
  const ExactQ q{Rational(3), Rational(3)};
  for (int n = 1; n <= 10; ++n) {
    EXPECT_EQ(q_integer(n, q), power(3, n - 1) * n);
    for (int k = 0; k <= n; ++k) {
      const Rational ordinary(binomial(n, k));
      EXPECT_EQ(q_binomials(n, q)[index(k)], power(3, k * (n - k)) * ordinary);
    }
  }
}

TEST(QNumbers, ExistWhereFactorialsVanish) {
  const ExactQ q{Rational(2), Rational(-2)};
  EXPECT_EQ(q_factorial(4, q), 0);
  EXPECT_EQ(q_binomials(4, q), (std::vector<Rational>{1, 0, 32, 0, 1}));
}

class QNumbersProperty : public ::testing::TestWithParam<int> {
 protected:
  ExactQ q() const {
    auto random = seeded(GetParam());
    Rational q1 = testing::nonzero_fraction(random), q2 = testing::nonzero_fraction(random);
    return {q1, q2};
  }
};

TEST_P(QNumbersProperty, IntegersAreTheQuotientOfDifferences) {
  const ExactQ q = this->q();
  if (q.q1 == q.q2) return;
  for (int n = 0; n <= 9; ++n)
    EXPECT_EQ(q_integer(n, q) * (q.q1 - q.q2), power(q.q1, n) - power(q.q2, n));
}

TEST_P(QNumbersProperty, BinomialsSatisfyBothPascalIdentities) {
  const ExactQ q = this->q();
  for (int n = 1; n <= 9; ++n) {
    const auto row = q_binomials(n, q), before = q_binomials(n - 1, q);
    for (int k = 1; k < n; ++k) {
      const Rational &stays = before[index(k)], &moves = before[index(k - 1)];
      EXPECT_EQ(row[index(k)], power(q.q1, k) * stays + power(q.q2, n - k) * moves);  // (2.1)
      EXPECT_EQ(row[index(k)], power(q.q2, k) * stays + power(q.q1, n - k) * moves);  // (2.2)
    }
  }
}

TEST_P(QNumbersProperty, BinomialsAreQuotientsOfFactorialsAndSymmetric) {
  const ExactQ q = this->q();
  for (int n = 0; n <= 9; ++n)
    for (int k = 0; k <= n; ++k) {
      const auto row = q_binomials(n, q);
      EXPECT_EQ(row[index(k)], row[index(n - k)]);
      EXPECT_EQ(row[index(k)] * q_factorial(k, q) * q_factorial(n - k, q), q_factorial(n, q));
    }
}

TEST_P(QNumbersProperty, BinomialsOfTheReciprocalsDifferByAPower) {
  const ExactQ q = this->q();
  const ExactQ inverse{Rational(1) / q.q1, Rational(1) / q.q2};
  const Rational product = q.q1 * q.q2;
  for (int k = 0; k <= 6; ++k)
    EXPECT_EQ(q_binomials(6, inverse)[index(k)],
              power(product, -k * (6 - k)) * q_binomials(6, q)[index(k)]);
}

TEST_P(QNumbersProperty, SumOverChoicesIsTheDiagonalFactorOfLemma23) {
  const ExactQ q = this->q();
  for (int n = 0; n <= 6; ++n)
    for (int k = 0; k <= n; ++k)
      EXPECT_EQ(q_diagonal_factors(n, q)[index(k)], sum_over_choices(n, k, q));
}

INSTANTIATE_TEST_SUITE_P(Seeds, QNumbersProperty, ::testing::Range(0, 12));

// Corollary 2.4 as corrected: for all k together the sums are non-zero exactly if n <= 1, or
// q1 q2 != 0 and not (q1 = -q2 with n even).
TEST(QBlossomObstacle, IsThereExactlyWhenASumOverChoicesVanishes) {
  int refused = 0;
  for (int n = 0; n <= 7; ++n)
    for (int first = -3; first <= 3; ++first)
      for (int second = -3; second <= 3; ++second) {
        if (first == 0 && second == 0) continue;
        const ExactQ q{Rational(first), Rational(second)};
        bool vanishes = false;
        for (int k = 0; k <= n; ++k) vanishes = vanishes || sum_over_choices(n, k, q) == 0;
        EXPECT_EQ(!q_blossom_obstacle(n, q).empty(), vanishes)
            << "n = " << n << ", q = " << first << ", " << second;
        refused += vanishes ? 1 : 0;
      }
  EXPECT_EQ(refused, 6 * 12 + 3 * 6);  // one is 0, six degrees; q1 = -q2, three even degrees
}

TEST(QBlossomObstacle, SaysWhatIsWrong) {
  EXPECT_EQ(q_blossom_obstacle(2, QParameters{0, 1}),
            "q1 = 0 and the degree is 2: x^k y^(n-k) has no (q1,q2)-blossom for k >= 2");
  EXPECT_EQ(q_blossom_obstacle(4, QParameters{5, -5}),
            "q1 = -q2 = 5 and the degree is 4: x^k y^(n-k) has no (q1,q2)-blossom for odd k, "
            "since n is even");
}

TEST(QBasisObstacle, NamesTheEqualPowers) {
  EXPECT_EQ(q_basis_obstacle(3, Interval{1, 4}, QParameters{2, 1}),
            "q1^2 a = q2^2 b on [1, 4] with q1 = 2, q2 = 1: the basis of degree 3 divides by their "
            "difference");
  EXPECT_EQ(q_basis_obstacle(2, Interval{1, 4}, QParameters{2, 1}), "");
}

TEST(QBasisObstacle, InDoubleIncludesDifferencesLostInRounding) {
  const double third = 1.0 / 3;  // q1^2 a = 1/9 to rounding
  EXPECT_NE(q_basis_obstacle(3, Interval{1, third * third}, QParameters{third, 1}), "");
  EXPECT_EQ(q_basis_obstacle(3, Interval{1, 1.0 / 9 + 1e-13}, QParameters{third, 1}), "");
}

TEST(QNumbers, RefuseWhatIsOutOfRange) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(q_integer(-1, QParameters{}), InvalidInput);
  EXPECT_THROW(q_binomials(26, QParameters{}), InvalidInput);
  EXPECT_THROW(q_factorial(3, QParameters{1, nan}), InvalidInput);
  EXPECT_THROW(q_diagonal_factors(3, QParameters{nan, 1}), InvalidInput);
  EXPECT_THROW(q_blossom_obstacle(3, QParameters{nan, 1}), InvalidInput);
  EXPECT_THROW(q_basis_obstacle(3, Interval{0, nan}, QParameters{}), InvalidInput);
}

}  // namespace
}  // namespace blossom
