// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/math/matrix.h"

#include <gtest/gtest.h>

#include "core/math/vec.h"

namespace blossom {
namespace {

Grid<double> matrix() {
  Grid<double> a(2, 3);
  a(0, 0) = 1, a(0, 1) = 2, a(0, 2) = 3;
  a(1, 0) = 4, a(1, 1) = 5, a(1, 2) = 6;
  return a;
}

TEST(MatrixProduct, HasHandValues) {
  Grid<double> b(3, 1);
  b(0, 0) = 1, b(1, 0) = -1, b(2, 0) = 2;

  const Grid<double> c = product(matrix(), b);

  EXPECT_EQ(c.rows(), 2);
  EXPECT_EQ(c.columns(), 1);
  EXPECT_EQ(c(0, 0), 5);
  EXPECT_EQ(c(1, 0), 11);
}

TEST(MatrixProduct, TakesPoints) {
  const std::vector<Vec2> points{{1, 0}, {0, 1}, {1, 1}};

  const std::vector<Vec2> result = product(matrix(), points);

  EXPECT_EQ(result, (std::vector<Vec2>{{4, 5}, {10, 11}}));
}

TEST(MatrixProduct, WithATransposeWorksOnRows) {
  Grid<Vec2> row(1, 3);
  row(0, 0) = {1, 0}, row(0, 1) = {0, 1}, row(0, 2) = {1, 1};

  const Grid<Vec2> result = product_transposed(row, matrix());

  EXPECT_EQ(result.rows(), 1);
  EXPECT_EQ(result(0, 0), (Vec2{4, 5}));
  EXPECT_EQ(result(0, 1), (Vec2{10, 11}));
}

}  // namespace
}  // namespace blossom
