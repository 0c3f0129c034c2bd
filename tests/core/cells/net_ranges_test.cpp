// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/cells/net_ranges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::seeded;
using testing::uniform;

TEST(NetRanges, OfValuesAndHeightsHoldAllAndNoMore) {
  auto random = seeded(4);
  const Vec3 normal{0.6, -0.48, 0.64};
  for (int count = 1; count <= 20; ++count) {
    std::vector<double> p(static_cast<std::size_t>(3 * count));
    for (double& x : p) x = uniform(random, -1, 1);
    const auto at = [&](int axis, int i) { return p[static_cast<std::size_t>(axis * count + i)]; };
    Range values{9, -9}, heights{9, -9};
    for (int i = 0; i < count; ++i) {
      const double h = normal[0] * at(0, i) + normal[1] * at(1, i) + normal[2] * at(2, i);
      values = {std::min(values.low, at(0, i)), std::max(values.high, at(0, i))};
      heights = {std::min(heights.low, h), std::max(heights.high, h)};
    }
    const Range found = value_range(p.data(), count),
                found_h = height_range(p.data(), count, normal);
    EXPECT_EQ(found.low, values.low);
    EXPECT_EQ(found.high, values.high);
    EXPECT_NEAR(found_h.low, heights.low, 1e-15);
    EXPECT_NEAR(found_h.high, heights.high, 1e-15);
  }
}

// A net of the quadratic itself leaves nothing; one of twice it leaves its own coefficients.
TEST(NetRanges, OfHeightsLessAQuadraticAreThoseOfTheRest) {
  auto random = seeded(5);
  const Vec3 normal{0, 0, 1};
  for (int rows = 2; rows <= 5; ++rows)
    for (int columns = 2; columns <= 5; ++columns) {
      Quadratic f;
      for (double* c : {&f.constant, &f.x, &f.y, &f.xy}) *c = uniform(random, -1, 1);
      if (rows > 2) f.xx = uniform(random, -1, 1);
      if (columns > 2) f.yy = uniform(random, -1, 1);
      // The polar form: coefficient i takes i of the arguments 1/2 and the others -1/2.
      const auto powers = [](int i, int n) {
        const double sum = i - 0.5 * n;
        return std::pair{sum / n, n > 1 ? (sum * sum - 0.25 * n) / (n * (n - 1)) : 0};
      };
      const int size = rows * columns;
      std::vector<double> p(static_cast<std::size_t>(3 * size));
      Range own{9, -9};
      for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
          const auto [x, xx] = powers(i, rows - 1);
          const auto [y, yy] = powers(j, columns - 1);
          const double h = f.constant + f.x * x + f.y * y + f.xx * xx + f.xy * x * y + f.yy * yy;
          p[static_cast<std::size_t>(2 * size + i * columns + j)] = h;
          own = {std::min(own.low, h), std::max(own.high, h)};
        }
      const Range rest = height_range(p.data(), rows, columns, normal, f);
      EXPECT_NEAR(rest.low, 0, 1e-15);
      EXPECT_NEAR(rest.high, 0, 1e-15);
      for (double& h : p) h *= 2;
      const Range half = height_range(p.data(), rows, columns, normal, f);
      EXPECT_NEAR(half.low, own.low, 1e-15);
      EXPECT_NEAR(half.high, own.high, 1e-15);
    }
}

TEST(NetRanges, AreThoseOfAllDifferences) {
  auto random = seeded(3);
  for (int rows = 2; rows <= 7; ++rows)
    for (int columns = 2; columns <= 9; ++columns) {
      std::vector<double> p(static_cast<std::size_t>(rows * columns));
      for (double& x : p) x = uniform(random, -1, 1);
      const auto at = [&](int i, int j) { return p[static_cast<std::size_t>(i * columns + j)]; };
      Range u{9, -9}, v{9, -9};
      SecondDifferences second;
      const auto widen = [](Range& range, double d) {
        range = {std::min(range.low, d), std::max(range.high, d)};
      };
      for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
          if (i + 1 < rows) widen(u, at(i + 1, j) - at(i, j));
          if (j + 1 < columns) widen(v, at(i, j + 1) - at(i, j));
          if (i + 2 < rows)
            second.uu = std::max(second.uu, std::abs(at(i, j) - 2 * at(i + 1, j) + at(i + 2, j)));
          if (j + 2 < columns)
            second.vv = std::max(second.vv, std::abs(at(i, j) - 2 * at(i, j + 1) + at(i, j + 2)));
          if (i + 1 < rows && j + 1 < columns)
            second.uv = std::max(
                second.uv, std::abs(at(i, j) - at(i, j + 1) - at(i + 1, j) + at(i + 1, j + 1)));
        }
      const Range found_u = difference_range_u(p.data(), rows, columns);
      const Range found_v = difference_range_v(p.data(), rows, columns);
      EXPECT_EQ(found_u.low, u.low);
      EXPECT_EQ(found_u.high, u.high);
      EXPECT_EQ(found_v.low, v.low);
      EXPECT_EQ(found_v.high, v.high);
      const SecondDifferences found = largest_second_differences(p.data(), rows, columns);
      EXPECT_NEAR(found.uu, second.uu, 1e-15);
      EXPECT_NEAR(found.uv, second.uv, 1e-15);
      EXPECT_NEAR(found.vv, second.vv, 1e-15);
    }
}

}  // namespace
}  // namespace blossom
