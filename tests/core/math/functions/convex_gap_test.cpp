// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/math/functions/convex_gap.h"

#include <gtest/gtest.h>

namespace blossom {
namespace {

struct Side {
  double x, gap, slope, bend;
};

// (x - c)^2 (1 + x / 4) - depth, convex on [0, 1].
struct CubicGap {
  double c, depth;
  mutable int asked = 0;

  Side operator()(double x) const {
    ++asked;
    const double d = x - c, w = 1 + x / 4;
    return {x, d * d * w - depth, 2 * d * w + d * d / 4, 2 * w + d};
  }
};

TEST(ConvexGap, LeastValueIsFoundInAFewSteps) {
  for (const double c : {0.01, 0.3, 0.5, 0.77}) {
    const CubicGap gap{c, 0};
    EXPECT_NEAR(least_between(gap(0), gap(1), gap).x, c, 1e-13);
    EXPECT_LE(gap.asked, 8) << c;
  }
}

TEST(ConvexGap, ZerosOnBothSidesAreFoundInAFewSteps) {
  for (const double depth : {1e-2, 1e-6, 1e-10}) {
    const CubicGap gap{0.4, depth};
    const Side bottom = least_between(gap(0), gap(1), gap);
    for (const double end : {0.0, 1.0}) {
      gap.asked = 0;
      const Side zero = zero_between(gap(end), bottom, gap, 1e-18);
      EXPECT_NEAR(zero.gap, 0, 1e-14);
      EXPECT_EQ(zero.x > 0.4, end > 0.4);
      EXPECT_LE(gap.asked, 16) << depth;
    }
  }
}

TEST(ConvexGap, DepthTellsZerosFromTouches) {
  const auto kinds = [](double depth) {
    const CubicGap gap{0.4, depth};
    int zeros = 0, touches = 0;
    EXPECT_TRUE(convex_points(
        gap(0), gap(1), {1e-7, 1e-15, 1, 4}, [&](double x, const Side&) { return gap(x); },
        [&](const Side&, bool touch) {
          ++(touch ? touches : zeros);
          return true;
        }));
    return 10 * touches + zeros;
  };
  EXPECT_EQ(kinds(1e-2), 2);
  EXPECT_EQ(kinds(1e-10), 2);
  EXPECT_EQ(kinds(1e-16), 10);
  EXPECT_EQ(kinds(-5e-8), 10);
  EXPECT_EQ(kinds(-5e-7), 0);
  EXPECT_EQ(kinds(0.3), 1);
}

}  // namespace
}  // namespace blossom
