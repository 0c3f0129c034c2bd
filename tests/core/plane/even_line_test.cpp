// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/plane/even_line.h"

#include <gtest/gtest.h>

namespace blossom {
namespace {

// From (0, 2) to (9, 2), with knots where another image of the same curve needs them.
Spline2 level_line(double along, double height) {
  return {3, {0, 1, 3}, {4, 2, 4}, {{0, 2}, {1, 2}, {along, height}, {5, 2}, {7, 2}, {9, 2}}};
}

TEST(EvenLine, IsOneSpan) {
  const Spline2 line = level_line(2, 2);
  EXPECT_TRUE(is_even_line(line));
  const PlanarCurve curve = simplest_curve(line);
  ASSERT_EQ(curve.spans.size(), 1U);
  EXPECT_EQ(curve.spans.front().curve.degree(), 1);
  for (const double t : {0.0, 0.4, 1.0, 2.5, 3.0}) {
    EXPECT_NEAR(point_at(curve, t)[0], 3 * t, 1e-14);
    EXPECT_EQ(point_at(curve, t)[1], 2);
  }
}

TEST(EvenLine, IsNoneThatRunsUnevenlyOrAside) {
  for (const Spline2& other : {level_line(2.1, 2), level_line(2, 2 + 1e-9)}) {
    EXPECT_FALSE(is_even_line(other));
    EXPECT_EQ(simplest_curve(other).spans.size(), 2U);
  }
}

}  // namespace
}  // namespace blossom
