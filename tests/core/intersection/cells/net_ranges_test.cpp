// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/intersection/cells/net_ranges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::seeded;
using testing::uniform;

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
