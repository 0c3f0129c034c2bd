// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/gap/contact_points.h"

#include <gtest/gtest.h>

#include "core/forms/evaluation.h"

namespace blossom {
namespace {

// (u, from + v, 0) over the unit square.
RationalBezierPatch sheet(double from) {
  RationalBezierPatch patch{Grid<Vec4>(2, 2)};
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      patch.points(i, j) = {static_cast<double>(i), from + static_cast<double>(j), 0, 1};
  return patch;
}

TEST(ContactPoints, WhatMovesToABorderTakesItsFootAlong) {
  const RationalBezierPatch a = sheet(0), b = sheet(0.3);
  const Point4 beyond_b{0.5, 0.29, 0.5, -0.01}, beyond_a{0.5, 1.01, 0.5, 0.71};
  for (const Point4& x : {beyond_b, beyond_a}) {
    const Point4 p = moved_into(a, b, x, 0.05);
    for (const double t : p) EXPECT_TRUE(t >= 0 && t <= 1);
    EXPECT_LE(distance(point_at(a, p[0], p[1]), point_at(b, p[2], p[3])), 1e-12);
  }
  const Point4 inside{0.2, 0.5, 0.2, 0.2};
  EXPECT_EQ(moved_into(a, b, inside, 0.05), inside);
}

}  // namespace
}  // namespace blossom
