// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/math/linear_solve.h"

#include <gtest/gtest.h>

#include "tests/support/random.h"

namespace blossom {
namespace {

TEST(LinearSolve, ExchangesRowsWhereAPivotIsZero) {
  Vec<double, 3> b{3, 5, 4};
  ASSERT_TRUE(solve<3>({Vec3{0, 1, 0}, Vec3{2, 0, 1}, Vec3{0, 0, 4}}, b));
  EXPECT_EQ(b, (Vec3{2, 3, 1}));
}

TEST(LinearSolve, LeavesResidualsOfRounding) {
  auto random = testing::seeded(1);
  for (int trial = 0; trial < 100; ++trial) {
    SquareMatrix<5> m{};
    Vec<double, 5> x, b;
    for (int j = 0; j < 5; ++j) x[j] = testing::uniform(random, -1, 1);
    for (auto& row : m)
      for (int j = 0; j < 5; ++j) row[j] = testing::uniform(random, -1, 1);
    for (int i = 0; i < 5; ++i) b[i] = dot(m[static_cast<std::size_t>(i)], x);
    Vec<double, 5> y = b;
    ASSERT_TRUE(solve<5>(m, y));
    for (int i = 0; i < 5; ++i)
      EXPECT_NEAR(dot(m[static_cast<std::size_t>(i)], y), b[i], 1e-13 * (1 + max_norm(y)));
  }
}

TEST(LinearSolve, RefusesAMatrixWithoutItsRank) {
  Vec<double, 2> b{1, 1};
  EXPECT_FALSE(solve<2>({Vec2{1, 2}, Vec2{2, 4}}, b));
  EXPECT_FALSE(solve<2>({Vec2{0, 0}, Vec2{0, 0}}, b));
}

TEST(SolvedByCramersRule, IsExactForSmallNumbersAndNothingIfDependent) {
  const Vec3 a{1, 0, 2}, b{0, 3, 1}, c{1, 1, 0};
  const auto x = solved(a, b, c, 2.0 * a - 1.0 * b + 4.0 * c);
  ASSERT_TRUE(x);
  EXPECT_EQ(*x, (Vec3{2, -1, 4}));
  EXPECT_FALSE(solved(a, b, a + b, c));
}

}  // namespace
}  // namespace blossom
