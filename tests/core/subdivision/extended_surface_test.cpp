// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/subdivision/extended_surface.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/forms/surface.h"

namespace blossom {
namespace {

// The graph of z = u^2 + u v over [0, 1] x [0, 2], with parameters from 10 and 20 on.
BezierSurface graph() {
  RationalBezierPatch patch{Grid<Vec4>(3, 2)};
  for (int i = 0; i <= 2; ++i)
    for (int k = 0; k <= 1; ++k)
      patch.points(i, k) = {0.5 * i, 2.0 * k, (i == 2 ? 1 : 0) + 0.5 * i * 2 * k, 1};
  BezierSurface surface{.u_knots = {10, 11}, .v_knots = {20, 22}};
  surface.patches = Grid<RationalBezierPatch>(1, 1);
  surface.patches(0, 0) = patch;
  return surface;
}

TEST(ExtendedSurface, GoesOnWithThePolynomialsOfItsBorders) {
  const BezierSurface made = extended(graph(), {0.5, 0.25}, {0, 1});
  EXPECT_EQ(made.u_knots, (std::vector<double>{9.5, 10, 11, 11.25}));
  EXPECT_EQ(made.v_knots, (std::vector<double>{20, 22, 24}));
  ASSERT_EQ(made.patches.rows(), 3);
  ASSERT_EQ(made.patches.columns(), 2);
  for (const double u : {-0.5, -0.2, 0.0, 0.6, 1.0, 1.25})
    for (const double v : {0.0, 1.5, 3.0, 4.0}) {
      const Vec3 expected{u, v, u * u + u * v};
      EXPECT_LE(distance(point_at(made, {10 + u, 20 + v}), expected), 1e-14) << u << ", " << v;
    }
}

TEST(ExtendedSurface, StaysAsItIsWhereItIsClosedOrRoundAnAxis) {
  BezierSurface surface = graph();
  surface.closed_u = true;
  surface.v_law = ParameterLaw::Angle;
  const BezierSurface made = extended(surface, {0.5, 0.5}, {0.5, 0.5});
  EXPECT_EQ(made.u_knots, surface.u_knots);
  EXPECT_EQ(made.v_knots, surface.v_knots);
}

// The weight of this one falls from 1 to 1/4 and would be 0 a third of the way on.
TEST(ExtendedSurface, HasNoSpanWithoutPositiveWeights) {
  BezierSurface surface = graph();
  for (int k = 0; k <= 1; ++k)
    for (int i = 0; i <= 2; ++i) surface.patches(0, 0).points(i, k)[3] = 1 - 0.375 * i;
  surface.rational = true;
  EXPECT_EQ(extended(surface, {0, 0.3}, {0, 0}).u_knots.size(), 3u);
  EXPECT_EQ(extended(surface, {0, 0.4}, {0, 0}).u_knots.size(), 2u);
}

}  // namespace
}  // namespace blossom
