// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/regions/cleaning/polynomial_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/base/errors.h"
#include "core/forms/algebra/interpolation.h"
#include "core/forms/evaluation.h"
#include "core/subdivision/patch_subdivision.h"
#include "tests/support/solids.h"

namespace blossom {
namespace {

using std::numbers::pi;

TEST(PolynomialSurface, OfASphereStaysWithinItsBound) {
  for (const double tolerance : {1e-3, 1e-6, 1e-8}) {
    const BezierSurface sphere = testing::unit_sphere();
    const BezierSurface made = polynomial_surface(sphere, tolerance);

    EXPECT_LE(made.error, tolerance);
    EXPECT_FALSE(made.rational);
    double seen = 0;
    for (double u = 0.01; u < 2 * pi; u += 0.1)
      for (double v = -1.57; v < 1.57; v += 0.1)
        seen = std::max(seen, distance(point_at(made, {u, v}), point_at(sphere, {u, v})));
    EXPECT_LE(seen, made.error);
    EXPECT_GE(seen, 0.02 * made.error);
  }
}

// A quarter of a cone: an angle along u, rational along v as well.
TEST(PolynomialSurface, OfAConeOfRationalLinesStaysWithinItsBound) {
  BezierSurface cone{{0, pi / 2}, {0, 1}};
  cone.u_law = ParameterLaw::Angle;
  cone.rational = true;
  cone.patches = Grid<RationalBezierPatch>(1, 1);
  Grid<Vec4>& net = cone.patches(0, 0).points = Grid<Vec4>(3, 2);
  const double w = std::sqrt(0.5);
  for (int j = 0; j < 2; ++j) {
    const double r = 2 + j, v = 1 + j;
    net(0, j) = {v * r, 0, v * j, v};
    net(1, j) = {v * w * r, v * w * r, v * w * j, v * w};
    net(2, j) = {0, v * r, v * j, v};
  }

  const BezierSurface made = polynomial_surface(cone, 1e-6);

  EXPECT_LE(made.error, 1e-6);
  double seen = 0;
  for (double u = 0; u < pi / 2; u += 0.01)
    for (double v = 0; v <= 1; v += 0.01)
      seen = std::max(seen, distance(point_at(made, {u, v}), point_at(cone, {u, v})));
  EXPECT_LE(seen, made.error);
  EXPECT_GE(seen, 0.02 * made.error);
}

TEST(PolynomialSurface, OfARationalSplineComparesCoefficients) {
  BezierSurface surface{{0, 2}, {1, 3}};
  surface.rational = true;
  surface.patches = Grid<RationalBezierPatch>(1, 1);
  Grid<Vec4>& net = surface.patches(0, 0).points = Grid<Vec4>(3, 3);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const double w = 1 + 0.3 * i - 0.2 * j;
      net(i, j) = {w * i, w * j, w * (i - j) * i, w};
    }

  const BezierSurface made = polynomial_surface(surface, 1e-6);

  EXPECT_LE(made.error, 1e-6);
  double seen = 0;
  for (double u = 0; u <= 2; u += 0.05)
    for (double v = 1; v <= 3; v += 0.05)
      seen = std::max(seen, distance(point_at(made, {u, v}), point_at(surface, {u, v})));
  EXPECT_LE(seen, made.error);
  EXPECT_GE(seen, 0.02 * made.error);
}

// Nearly equal knots leave such spans; their parts would be narrower than what counts as equal.
TEST(PolynomialSurface, LeavesNarrowSpansWhole) {
  RationalBezierPatch whole{Grid<Vec4>(3, 2)};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 2; ++j) {
      const double w = i == 1 ? 0.6 : 1;
      whole.points(i, j) = {w * i, w * i * (2 - i), w * j, w};
    }
  BezierSurface surface{{0, 1e-8, 1}, {0, 1}};
  surface.rational = true;
  surface.patches = Grid<RationalBezierPatch>(2, 1);
  surface.patches(0, 0) = sub_patch(whole, {0, 1e-8}, {0, 1});
  surface.patches(1, 0) = sub_patch(whole, {1e-8, 1}, {0, 1});

  const BezierSurface made = polynomial_surface(surface, 1e-8);

  EXPECT_LE(made.error, 1e-8);
  ASSERT_GT(made.u_knots.size(), 4u);
  EXPECT_EQ(made.u_knots[1], 1e-8);
  EXPECT_EQ(made.v_knots.size(), 2u);
}

// A cubic height in three spans along u, of which one is far below what trims can tell; at either
// end or inside. Its neighbours take its place, within the bound.
TEST(PolynomialSurface, LosesSpansThatTrimsCannotTell) {
  const auto height = [](double u) { return u * u * (3 - u); };
  for (const double narrow : {0.0, 0.4, 1 - 1e-9}) {
    BezierSurface surface{{0, 1}, {0, 1}};
    if (narrow > 0) surface.u_knots.insert(surface.u_knots.end() - 1, narrow);
    if (narrow + 1e-9 < 1) surface.u_knots.insert(surface.u_knots.end() - 1, narrow + 1e-9);
    const int spans = static_cast<int>(surface.u_knots.size()) - 1;
    surface.patches = Grid<RationalBezierPatch>(spans, 1);
    for (int i = 0; i < spans; ++i) {
      const Interval span{surface.u_knots[static_cast<std::size_t>(i)],
                          surface.u_knots[static_cast<std::size_t>(i) + 1]};
      std::vector<Vec3> points;
      for (const double t : extreme_points(3))
        points.push_back({at(span, t), height(at(span, t)), 0});
      points = bezier_through(points).points;
      Grid<Vec4> net(4, 2);
      for (int a = 0; a < 4; ++a)
        for (int b = 0; b < 2; ++b) {
          const Vec3& p = points[static_cast<std::size_t>(a)];
          net(a, b) = {p[0], p[1], static_cast<double>(b), 1};
        }
      surface.patches(i, 0) = {net};
    }

    const BezierSurface made = polynomial_surface(surface, 1e-6);

    EXPECT_EQ(made.patches.rows(), spans - 1);
    EXPECT_EQ(made.u_knots.front(), 0);
    EXPECT_EQ(made.u_knots.back(), 1);
    EXPECT_GT(made.error, 0);
    EXPECT_LE(made.error, 3e-8);
    for (double u = 0; u <= 1; u += 1.0 / 64) {
      const Vec3 p = point_at(made, {u, 0.5});
      EXPECT_LE(distance(p, {u, height(u), 0.5}), made.error);
    }
    EXPECT_LE(distance(point_at(made, {1, 0.5}), {1, height(1), 0.5}), 1e-15);
  }
}

// However narrow a span is in its parameter, it stays where it is long in space.
TEST(PolynomialSurface, KeepsNarrowSpansThatAreLong) {
  BezierSurface surface{{0, 1e-9, 1}, {0, 1}};
  surface.patches = Grid<RationalBezierPatch>(2, 1);
  for (int i = 0; i < 2; ++i) {
    Grid<Vec4> net(2, 2);
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b) net(a, b) = {10.0 * (i + a), 1.0 * b, 0, 1};
    surface.patches(i, 0) = {net};
  }

  const BezierSurface made = polynomial_surface(surface, 1e-6);

  EXPECT_EQ(made.u_knots, surface.u_knots);
  EXPECT_EQ(made.patches, surface.patches);
  EXPECT_EQ(made.error, 0);
}

TEST(PolynomialSurface, OfAPolynomialIsItself) {
  BezierSurface saddle{{0, 1}, {0, 1}};
  Grid<Vec4> net(2, 2);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) net(i, j) = {1.0 * i, 1.0 * j, 1.0 * i * j, 1};
  saddle.patches = Grid<RationalBezierPatch>(1, 1, RationalBezierPatch{net});

  EXPECT_EQ(polynomial_surface(saddle, 1e-9).patches, saddle.patches);
  EXPECT_THROW(polynomial_surface(saddle, 0), InvalidInput);
}

}  // namespace
}  // namespace blossom
