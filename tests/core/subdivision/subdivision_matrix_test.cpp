// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/subdivision/subdivision_matrix.h"

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "core/base/unbounded.h"
#include "core/math/detail/bernstein.h"
#include "tests/support/exact.h"
#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::exact_gap;
using testing::Rational;
using testing::seeded;
using testing::uniform;

TEST(SubdivisionMatrix, OfTheLowerHalfOfAParabolaIsKnownByHand) {
  const Grid<double> s = subdivision_matrix(2, {0, 0.5});

  const double expected[3][3] = {{1, 0, 0}, {0.5, 0.5, 0}, {0.25, 0.5, 0.25}};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) EXPECT_EQ(s(i, j), expected[i][j]);
}

TEST(SubdivisionMatrix, OfTheWholeIntervalIsTheIdentity) {
  for (int n = 0; n <= kMaxDegree; ++n) {
    const Grid<double> s = subdivision_matrix(n, {0, 1});
    const Grid<double> reversed = subdivision_matrix(n, {1, 0});
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j) {
        EXPECT_EQ(s(i, j), i == j ? 1 : 0);
        EXPECT_EQ(reversed(i, j), i == n - j ? 1 : 0);
      }
  }
}

TEST(MonomialMatrix, OfASquareIsKnownByHand) {
  const Grid<double> m = monomial_matrix(2, {1, 3});

  const double expected[3][3] = {{1, 1, 1}, {1, 2, 3}, {1, 3, 9}};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) EXPECT_EQ(m(i, j), expected[i][j]);
}

class SubdivisionMatrixProperty : public ::testing::TestWithParam<int> {
 protected:
  int degree() const { return GetParam() % 26; }
};

TEST_P(SubdivisionMatrixProperty, RowsSumToOne) {
  auto random = seeded(GetParam());
  const Grid<double> s =
      subdivision_matrix(degree(), {uniform(random, 0, 1), uniform(random, 0, 1)});
  for (int i = 0; i <= degree(); ++i) {
    double sum = 0;
    for (int j = 0; j <= degree(); ++j) sum += s(i, j);
    EXPECT_NEAR(sum, 1, curve_subdivision_error(degree()));
  }
}

TEST_P(SubdivisionMatrixProperty, RowsSumToOneExactlyInRationals) {
  auto random = seeded(GetParam());
  const IntervalOf<Rational> piece{Rational(uniform(random, -2, 2)), Rational(1) / 3};
  const Grid<Rational> s = detail::subdivision_matrix(degree(), piece);
  for (int i = 0; i <= degree(); ++i) {
    Rational sum = 0;
    for (int j = 0; j <= degree(); ++j) sum += s(i, j);
    EXPECT_EQ(sum, 1);
  }
}

TEST_P(SubdivisionMatrixProperty, HasNoNegativeEntryInsideTheUnitInterval) {
  auto random = seeded(GetParam());
  const Grid<double> s =
      subdivision_matrix(degree(), {uniform(random, 0, 1), uniform(random, 0, 1)});
  for (const double entry : s.values()) EXPECT_GE(entry, 0);
}

TEST_P(SubdivisionMatrixProperty, NeighboursShareARowBitForBit) {
  auto random = seeded(GetParam());
  const double cut = uniform(random, 0, 1);
  const Grid<double> before = subdivision_matrix(degree(), {uniform(random, 0, cut), cut});
  const Grid<double> after = subdivision_matrix(degree(), {cut, uniform(random, cut, 1)});
  for (int j = 0; j <= degree(); ++j) EXPECT_EQ(before(degree(), j), after(0, j));
}

TEST_P(SubdivisionMatrixProperty, EntriesAreAccurateRelativeToThemselves) {
  auto random = seeded(GetParam());
  const Interval piece{uniform(random, 0, 1), uniform(random, 0, 1)};
  const Grid<double> s = subdivision_matrix(degree(), piece);
  const Grid<Rational> expected = detail::subdivision_matrix(
      degree(), IntervalOf<Rational>{Rational(piece.from), Rational(piece.to)});
  for (int i = 0; i <= degree(); ++i)
    for (int j = 0; j <= degree(); ++j)
      EXPECT_LE(exact_gap(s(i, j), expected(i, j)),
                curve_subdivision_error(degree()) * expected(i, j).convert_to<double>());
}

INSTANTIATE_TEST_SUITE_P(Seeds, SubdivisionMatrixProperty, ::testing::Range(0, 26));

TEST(SubdivisionMatrix, RefusesDegreesOutOfRangeAndEndsThatAreNotFinite) {
  EXPECT_THROW(subdivision_matrix(-1, {0, 1}), InvalidInput);
  EXPECT_THROW(subdivision_matrix(26, {0, 1}), InvalidInput);
  EXPECT_THROW(subdivision_matrix(3, {0, kInfinity}), InvalidInput);
  EXPECT_THROW(monomial_matrix(26, {0, 1}), InvalidInput);
  EXPECT_THROW(monomial_matrix(3, {-kInfinity, 1}), InvalidInput);
}

}  // namespace
}  // namespace blossom
