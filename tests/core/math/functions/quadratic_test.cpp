// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/math/functions/quadratic.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math/series/taylor_series.h"
#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::seeded;
using testing::uniform;

TEST(Quadratic, RangeIsThatOfItsValues) {
  auto random = seeded(7);
  for (int draw = 0; draw < 400; ++draw) {
    Quadratic f;
    for (double* c : {&f.constant, &f.x, &f.y, &f.xx, &f.xy, &f.yy}) *c = uniform(random, -1, 1);
    if (draw % 5 == 0) f.xx = f.xy = 0;
    if (draw % 7 == 0) f.yy = 0;
    const Interval u{uniform(random, -1, 0), uniform(random, 0, 1)};
    const Interval v{uniform(random, -1, 0), uniform(random, 0, 1)};
    PolynomialRange seen{1e300, -1e300};
    for (int i = 0; i <= 60; ++i)
      for (int j = 0; j <= 60; ++j) {
        const double value = f.at(at(u, i / 60.0), at(v, j / 60.0));
        seen = {std::min(seen.low, value), std::max(seen.high, value)};
      }

    const PolynomialRange found = range(f, u, v);

    EXPECT_LE(found.low, seen.low + 1e-14);
    EXPECT_GE(found.high, seen.high - 1e-14);
    EXPECT_NEAR(found.low, seen.low, 2e-3);
    EXPECT_NEAR(found.high, seen.high, 2e-3);
  }
}

// A valley along the diagonal that is hardly curved: its lowest place is known to no digit, its
// bottom to all of them.
TEST(Quadratic, RangeHoldsTheBottomOfANarrowValley) {
  auto random = seeded(11);
  for (int draw = 0; draw < 20000; ++draw) {
    const double p = uniform(random, 0.5, 1), q = uniform(random, 0.5, 1);
    const double s = uniform(random, -0.4, 0.4), t = uniform(random, -0.4, 0.4);
    Quadratic f;
    f.xx = p * p;
    f.yy = q * q + std::pow(10, uniform(random, -13, -8));
    f.xy = 2 * p * q;
    f.x = -(2 * f.xx * s + f.xy * t);
    f.y = -(f.xy * s + 2 * f.yy * t);
    EXPECT_LE(range(f, {-0.5, 0.5}, {-0.5, 0.5}).low, f.at(s, t) + 4e-15);
  }
}

// A bowl in the middle of the square: Bernstein coefficients go below its bottom.
TEST(TaylorPolynomial, CloseRangeKnowsTheBottomOfABowl) {
  TaylorPolynomial p{};
  p[taylor_index(0, 0)] = 1e-3;
  p[taylor_index(2, 0)] = p[taylor_index(0, 2)] = 1;
  p[taylor_index(3, 0)] = 1e-4;
  EXPECT_LT(range(p, 1, 1).low, 0);
  EXPECT_GT(close_range(p).low, 0);
  EXPECT_LE(close_range(p).low, 1e-3);
  EXPECT_GE(close_range(p).high, 2.001);
}

}  // namespace
}  // namespace blossom
