// SPDX-License-Identifier: LGPL-2.1-or-later
// Ranges and isolated roots of polynomials against polynomials with chosen roots.
#include "core/math/functions/polynomial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::Random;
using testing::seeded;
using testing::uniform;

Polynomial with_roots(const std::vector<double>& roots, double factor = 1) {
  Polynomial p{factor};
  std::size_t degree = 0;
  for (const double root : roots) {
    ++degree;
    for (std::size_t i = degree; i > 0; --i) p[i] = p[i - 1] - root * p[i];
    p[0] *= -root;
  }
  return p;
}

class PolynomialProperty : public ::testing::TestWithParam<int> {};

TEST_P(PolynomialProperty, RangeHoldsAllValuesAndTheEnds) {
  Random random = seeded(GetParam());
  Polynomial p;
  for (double& c : p) c = uniform(random, -1, 1);
  const PolynomialRange bounds = range(p);

  for (int i = 0; i <= 100; ++i) {
    const double y = value(p, -1 + 0.02 * i);
    EXPECT_GE(y, bounds.low - 1e-13);
    EXPECT_LE(y, bounds.high + 1e-13);
  }
  EXPECT_LE(bounds.high, 7);  // the sum of the largest coefficients there may be
}

TEST_P(PolynomialProperty, ChosenRootsAreFoundInOrder) {
  Random random = seeded(GetParam());
  std::vector<double> roots;
  for (int i = 0; i < 6; ++i) roots.push_back(uniform(random, -1.5, 1.5));
  const Polynomial p = with_roots(roots, uniform(random, 0.5, 2));
  std::erase_if(roots, [](double t) { return std::abs(t) > 1; });
  std::sort(roots.begin(), roots.end());

  const auto found = isolated_roots(p, 1e-15, 1e-15, -1, 1);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->size(), roots.size());
  for (std::size_t i = 0; i < roots.size(); ++i) {
    EXPECT_NEAR((*found)[i].t, roots[i], 1e-9);
    EXPECT_EQ((*found)[i].rising, value(p, (*found)[i].t + 1e-4) > 0);
  }
}

TEST_P(PolynomialProperty, SlopeIsThatOfADifferenceQuotient) {
  Random random = seeded(GetParam());
  Polynomial p;
  for (double& c : p) c = uniform(random, -1, 1);
  const double t = uniform(random, -1, 1), h = 1e-5;

  const PolynomialJet jet = jet_at(p, t);

  EXPECT_DOUBLE_EQ(jet.value, value(p, t));
  EXPECT_NEAR(jet.slope, (value(p, t + h) - value(p, t - h)) / (2 * h), 1e-7);
}

INSTANTIATE_TEST_SUITE_P(Random, PolynomialProperty, ::testing::Range(0, 20));

TEST(IsolatedRoots, AreOnlyThoseOfTheInterval) {
  const auto found = isolated_roots(with_roots({-0.9, -0.2, 0.3, 0.8}), 0, 0, -0.5, 0.5);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->size(), 2u);
  EXPECT_NEAR((*found)[0].t, -0.2, 1e-14);
  EXPECT_NEAR((*found)[1].t, 0.3, 1e-14);
}

TEST(IsolatedRoots, OfADoubleRootAreUndecided) {
  EXPECT_FALSE(isolated_roots(with_roots({0.3, 0.3}), 1e-12, 1e-12, -1, 1));
}

// Within the error the two roots may be one, or none.
TEST(IsolatedRoots, CloserThanTheErrorAreUndecided) {
  const Polynomial p = with_roots({0.3, 0.3 + 1e-4});
  EXPECT_FALSE(isolated_roots(p, 1e-8, 0, -1, 1));
  const auto found = isolated_roots(p, 1e-12, 0, -1, 1);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->size(), 2u);
}

TEST(IsolatedRoots, WithinTheErrorOfAnEndAreUndecided) {
  EXPECT_FALSE(isolated_roots(with_roots({1 - 1e-10}), 1e-9, 0, -1, 1));
}

}  // namespace
}  // namespace blossom
