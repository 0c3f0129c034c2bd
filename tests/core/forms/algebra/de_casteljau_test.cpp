// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/algebra/de_casteljau.h"

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "core/forms/algebra/conversion.h"
#include "tests/support/shapes.h"

namespace blossom {
namespace {

using testing::coordinate_gap;
using testing::random_curve;
using testing::random_patch;
using testing::reference_point;
using testing::seeded;
using testing::uniform;

TEST(DeCasteljau, EvaluatesTheParabolaOfHandValues) {
  const BezierCurve2 parabola{{{0, 0}, {1, 2}, {2, 0}}};  // (2t, 4t - 4t^2)

  const auto found = derivatives_at(parabola, 0.25);

  EXPECT_EQ(found.point, (Vec2{0.5, 0.75}));
  EXPECT_EQ(found.first, (Vec2{2, 2}));
  EXPECT_EQ(found.second, (Vec2{0, -8}));
}

TEST(DeCasteljau, HasZeroDerivativesAboveTheDegree) {
  const auto point = derivatives_at(BezierCurve2{{{3, 4}}}, 0.5);
  EXPECT_EQ(point.point, (Vec2{3, 4}));
  EXPECT_EQ(point.first, Vec2{});
  const auto line = derivatives_at(BezierCurve2{{{0, 0}, {1, 1}}}, 0.5);
  EXPECT_EQ(line.first, (Vec2{1, 1}));
  EXPECT_EQ(line.second, Vec2{});
}

TEST(DeCasteljau, EvaluatesTheTriangleCornersByTheIndexConvention) {
  auto random = seeded(1);
  const BezierTriangle triangle = testing::random_triangle(random, 3);

  EXPECT_EQ(point_at(triangle, 1, 0), triangle(3, 0));
  EXPECT_EQ(point_at(triangle, 0, 1), triangle(0, 3));
  EXPECT_EQ(point_at(triangle, 0, 0), triangle(0, 0));
}

class DeCasteljauProperty : public ::testing::TestWithParam<int> {};

TEST_P(DeCasteljauProperty, PointsAreWithinTheStatedError) {
  auto random = seeded(GetParam());
  const int n = GetParam() % 26, m = GetParam() % 9;
  const BezierCurve curve = random_curve(random, n);
  const RationalBezierPatch patch = random_patch<Vec4>(random, n, m);
  const double u = uniform(random, 0, 1), v = uniform(random, 0, 1);

  EXPECT_LE(coordinate_gap(point_at(curve, u), reference_point(curve, u)), de_casteljau_error(n));
  EXPECT_LE(coordinate_gap(point_at(patch, u, v), reference_point(patch, u, v)),
            de_casteljau_error(n + m));
}

TEST_P(DeCasteljauProperty, DerivativesOfACurveAreThoseOfItsPolynomial) {
  auto random = seeded(GetParam());
  const int n = GetParam() % 8;
  const BezierCurve curve = random_curve(random, n);
  const double t = uniform(random, 0, 1);
  MonomialCurve first = monomial_form(curve, Origin::Start), second = first;
  for (int i = 0; i <= n; ++i) {
    first.coefficients[static_cast<std::size_t>(i)] *= i / (i > 0 ? t : 1);
    second.coefficients[static_cast<std::size_t>(i)] *= i * (i - 1) / (i > 1 ? t * t : 1);
  }
  // Relative to the sizes of the terms, with the growth of the plain power basis.
  const double bound = 20 * n * n * monomial_growth(n, 0, Origin::Start) * 0x1p-53;

  const auto found = derivatives_at(curve, t);

  EXPECT_LE(coordinate_gap(found.first, reference_point(first, t)), bound);
  EXPECT_LE(coordinate_gap(found.second, reference_point(second, t)), bound * n);
}

TEST_P(DeCasteljauProperty, DerivativesOfAPatchAreThoseOfItsIsoCurves) {
  auto random = seeded(GetParam());
  const int n = GetParam() % 7, m = GetParam() % 5;
  const BezierPatch patch = random_patch(random, n, m);
  const double u = uniform(random, 0, 1), v = uniform(random, 0, 1);
  BezierCurve along_u, u_derivatives;  // the curve u -> S(u, v), and S_u(u, .) as a curve of v
  for (int i = 0; i <= n; ++i) {
    BezierCurve row;
    for (int j = 0; j <= m; ++j) row.points.push_back(patch.points(i, j));
    along_u.points.push_back(point_at(row, v));
  }
  for (int j = 0; j <= m; ++j) {
    BezierCurve column;
    for (int i = 0; i <= n; ++i) column.points.push_back(patch.points(i, j));
    u_derivatives.points.push_back(derivatives_at(column, u).first);
  }
  const double bound = 100 * (n + m + 1) * (n + m + 1) * 0x1p-53;

  const auto found = derivatives_at(patch, u, v);
  const auto expected = derivatives_at(along_u, u);

  EXPECT_LE(coordinate_gap(found.point, expected.point), bound);
  EXPECT_LE(coordinate_gap(found.u, expected.first), bound * (n + 1));
  EXPECT_LE(coordinate_gap(found.uu, expected.second), bound * (n + 1) * (n + 1));
  EXPECT_LE(coordinate_gap(found.uv, derivatives_at(u_derivatives, v).first),
            bound * (n + 1) * (m + 1));
}

INSTANTIATE_TEST_SUITE_P(Seeds, DeCasteljauProperty, ::testing::Range(0, 26));

TEST(DeCasteljau, DerivativesAlongVAreThoseAlongUOfTheTransposedPatch) {
  auto random = seeded(7);
  const BezierPatch patch = random_patch(random, 3, 4);
  BezierPatch turned{Grid<Vec3>(5, 4)};
  for (int i = 0; i <= 3; ++i)
    for (int j = 0; j <= 4; ++j) turned.points(j, i) = patch.points(i, j);

  const auto found = derivatives_at(patch, 0.25, 0.625);
  const auto expected = derivatives_at(turned, 0.625, 0.25);

  EXPECT_LE(coordinate_gap(found.v, expected.u), 1e-14);
  EXPECT_LE(coordinate_gap(found.vv, expected.uu), 1e-13);
}

TEST(DeCasteljau, TakesCurvesOfTheDegreesThatProductsHave) {
  BezierCurve line;
  for (int k = 0; k <= 60; ++k) line.points.push_back({k / 60.0, 1, 0});

  EXPECT_LE(coordinate_gap(point_at(line, 0.25), Vec3{0.25, 1, 0}), de_casteljau_error(60));
}

TEST(DeCasteljau, RefusesNetsThatDoNotFit) {
  EXPECT_THROW(point_at(BezierCurve{}, 0.5), InvalidInput);
  EXPECT_THROW(point_at(BezierPatch{}, 0.5, 0.5), InvalidInput);
  EXPECT_THROW(point_at(BezierTriangle{2, std::vector<Vec3>(5)}, 0.5, 0.25), InvalidInput);
  EXPECT_THROW(derivatives_at(BezierCurve{std::vector<Vec3>(62)}, 0.5), InvalidInput);
}

}  // namespace
}  // namespace blossom
