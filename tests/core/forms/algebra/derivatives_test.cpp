// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/algebra/derivatives.h"

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "core/blossom/detail/triangle_conversion.h"
#include "core/forms/algebra/de_casteljau.h"
#include "core/forms/algebra/detail/derivatives.h"
#include "tests/core/forms/exact_forms.h"
#include "tests/support/shapes.h"

namespace blossom {
namespace {

using testing::exact;
using testing::exact_gap;
using testing::exact_point;
using testing::pick;
using testing::random_curve;
using testing::random_patch;
using testing::random_triangle;
using testing::Rational;
using testing::seeded;
using testing::uniform;

// Coordinates in [-1, 1), weights in [1/2, 1).
RationalBezierPatch random_rational(testing::Random& random, int n, int m) {
  RationalBezierPatch patch = random_patch<Vec4>(random, n, m);
  for (Vec4& point : patch.points.values()) point[3] = uniform(random, 0.5, 1);
  return patch;
}

RationalBezierTriangle random_rational_triangle(testing::Random& random, int degree) {
  RationalBezierTriangle triangle{degree, {}};
  for (const Vec3& p : random_triangle(random, degree).points)
    triangle.points.push_back({p[0], p[1], p[2], uniform(random, 0.5, 1)});
  return triangle;
}

TEST(Derivatives, OfTheTwistedCubicAreKnownByHand) {
  const BezierCurve cubic{{{0, 0, 0}, {1.0, 0, 0}, {2.0, 1, 0}, {3, 3, 1}}};  // (3t, 3t^2, t^3)

  EXPECT_EQ(derivative(cubic, 1).points, (std::vector<Vec3>{{3, 0, 0}, {3, 3, 0}, {3, 6, 3}}));
  EXPECT_EQ(derivative(cubic, 3).points, (std::vector<Vec3>{{0, 0, 6}}));
  EXPECT_EQ(derivative(cubic, 4).points, (std::vector<Vec3>{{0, 0, 0}}));
  EXPECT_EQ(derivative(cubic, 0), cubic);
}

TEST(Derivatives, OfATriangleAreThoseOfItsBarycentricCoordinates) {
  // x^2 + 3 y: q_20 = 1, q_11 = 3/2, q_02 = 3, q_01 = 3/2.
  BezierTriangle triangle{2, std::vector<Vec3>(6)};
  triangle(2, 0) = {1, 0, 0};
  triangle(1, 1) = {1.5, 0, 0};
  triangle(0, 2) = {3, 0, 0};
  triangle(0, 1) = {1.5, 0, 0};

  const BezierTriangle along_x = derivative(triangle, 1, 0);

  EXPECT_EQ(along_x(1, 0), (Vec3{2, 0, 0}));
  EXPECT_EQ(along_x(0, 1), (Vec3{0, 0, 0}));
  EXPECT_EQ(derivative(triangle, 2, 0).points[0], (Vec3{2, 0, 0}));
  EXPECT_EQ(derivative(triangle, 0, 1)(0, 0), (Vec3{3, 0, 0}));
  EXPECT_EQ(derivative(triangle, 2, 1).points[0], (Vec3{0, 0, 0}));
}

TEST(Derivatives, OfARationalQuarterCircleAreTangentAndPointInwards) {
  const RationalBezierCurve circle{{{1, 0, 0, 1}, {1, 1, 0, 1}, {0, 2, 0, 2}}};

  const RationalBezierCurve first = rational_derivative(circle, 1);

  ASSERT_EQ(first.degree(), 4);
  EXPECT_EQ(first.points[0], (Vec4{0, 2, 0, 1}));  // x = (1 - t^2, 2t) / (1 + t^2)
  for (double t : {0.25, 0.5, 1.0}) {
    const Vec4 d = point_at(first, t), h = point_at(circle, t);
    EXPECT_NEAR(d[0] * h[0] + d[1] * h[1], 0, 1e-14);
  }
  const Vec4 second = rational_derivative(circle, 2).points[0];
  EXPECT_EQ(second, (Vec4{-4, 0, 0, 1}));
}

TEST(Derivatives, OfARationalTriangleFollowTheQuotientRule) {
  // x / (1 + x) over 1 + x: its derivative is 1 / (1 + x)^2, and the second one -2 / (1 + x)^3.
  const RationalBezierTriangle triangle{1, {{0, 0, 0, 1}, {0, 0, 0, 1}, {1, 0, 0, 2}}};

  const RationalBezierTriangle first = rational_derivative(triangle, 1, 0);
  const RationalBezierTriangle second = rational_derivative(triangle, 2, 0);

  ASSERT_EQ(first.degree, 2);
  EXPECT_EQ(first(2, 0), (Vec4{1, 0, 0, 4}));
  EXPECT_EQ(first(1, 1), (Vec4{1, 0, 0, 2}));
  EXPECT_EQ(first(0, 2), (Vec4{1, 0, 0, 1}));
  ASSERT_EQ(second.degree, 3);
  EXPECT_EQ(second(3, 0), (Vec4{-2, 0, 0, 8}));
  EXPECT_EQ(second(0, 3), (Vec4{-2, 0, 0, 1}));
  EXPECT_EQ(rational_derivative(triangle, 0, 1)(1, 1), (Vec4{0, 0, 0, 2}));
}

class DerivativesProperty : public ::testing::TestWithParam<int> {};

TEST_P(DerivativesProperty, AgreeWithThoseOfDeCasteljau) {
  auto random = seeded(GetParam());
  const BezierPatch patch = random_patch(random, pick(random, 1, 6), pick(random, 1, 6));
  const double u = uniform(random, 0, 1), v = uniform(random, 0, 1);

  const PatchDerivatives<Vec3> jet = derivatives_at(patch, u, v);

  EXPECT_LE(max_norm(point_at(derivative(patch, 1, 0), u, v) - jet.u), 1e-13);
  EXPECT_LE(max_norm(point_at(derivative(patch, 1, 1), u, v) - jet.uv), 1e-12);
  EXPECT_LE(max_norm(point_at(derivative(patch, 0, 2), u, v) - jet.vv), 1e-12);
}

TEST_P(DerivativesProperty, AreWithinTheStatedErrorOfTheExactOnes) {
  auto random = seeded(GetParam());
  const int n = pick(random, 0, 25), order = pick(random, 0, 4);
  const BezierCurve curve = random_curve(random, n);
  const BezierPatch patch = random_patch(random, 4, 3);

  const BezierCurve computed = derivative(curve, order);
  const auto expected = detail::derivative_net(detail::one_row(exact(curve.points)), 0, order);
  const BezierPatch mixed = derivative(patch, 2, order);
  const auto expected_mixed = detail::derivative_net(exact(patch.points), 2, order);

  ASSERT_EQ(computed.degree(), std::max(0, n - order));
  for (int k = 0; k <= computed.degree(); ++k)
    EXPECT_LE(exact_gap(computed.points[static_cast<std::size_t>(k)], expected(0, k)),
              derivative_error(n, order));
  for (int i = 0; i <= mixed.degree_u(); ++i)
    for (int j = 0; j <= mixed.degree_v(); ++j)
      EXPECT_LE(exact_gap(mixed.points(i, j), expected_mixed(i, j)),
                derivative_error(4, 3, 2, order));
}

TEST_P(DerivativesProperty, OfRationalPatchesAreLimitsOfTheirDifferenceQuotients) {
  auto random = seeded(GetParam());
  const RationalBezierPatch patch = random_rational(random, 2, 3);
  const auto exact_net = exact(patch.points);
  const auto value = [&](const Rational& u, const Rational& v) -> Rational {
    const auto h = exact_point(exact_net, u, v);
    return h[0] / h[3];
  };
  const Rational step(1, 1 << 20), u(1, 3), v(2, 5);

  const auto mixed = exact_point(detail::rational_derivative(exact_net, 1, 1), u, v);
  const auto second = exact_point(detail::rational_derivative(exact_net, 0, 2), u, v);

  const Rational corners = value(u + step, v + step) - value(u + step, v - step) -
                           value(u - step, v + step) + value(u - step, v - step);
  const Rational row = value(u, v + step) - 2 * value(u, v) + value(u, v - step);
  EXPECT_LE(abs(Rational(corners / (4 * step * step) - mixed[0] / mixed[3])), Rational(1, 1 << 20));
  EXPECT_LE(abs(Rational(row / (step * step) - second[0] / second[3])), Rational(1, 1 << 20));
}

TEST_P(DerivativesProperty, OfRationalPatchesAreWithinTheStatedError) {
  auto random = seeded(GetParam());
  const int n = pick(random, 0, 4), m = pick(random, 0, 3), order = pick(random, 0, 2);
  const RationalBezierPatch patch = random_rational(random, n, m);

  const RationalBezierPatch computed = rational_derivative(patch, 1, order);
  const auto expected = detail::rational_derivative(exact(patch.points), 1, order);

  ASSERT_EQ(computed.degree_u(), (order + 2) * n);
  ASSERT_EQ(computed.degree_v(), (order + 2) * m);
  for (int i = 0; i <= computed.degree_u(); ++i)
    for (int j = 0; j <= computed.degree_v(); ++j)
      EXPECT_LE(exact_gap(computed.points(i, j), expected(i, j)),
                rational_derivative_error(n, m, order + 1));
}

TEST_P(DerivativesProperty, OfRationalTrianglesAreThoseOfTheirCollapsedPatches) {
  // On the side y = 0 of T(u (1 - v), u v): d/du is d/dx, and d/dv = u (d/dy - d/dx).
  auto random = seeded(GetParam());
  const auto triangle = exact(random_rational_triangle(random, pick(random, 1, 4)));
  const auto patch = detail::collapsed_net(triangle);
  const auto value = [](const auto& h) { return Vec<Rational, 3>{h[0], h[1], h[2]} * (1 / h[3]); };
  const Rational u(2, 5), v(0);

  const auto of = [&](int order_x, int order_y) {
    return value(exact_point(detail::rational_derivative(triangle, order_x, order_y), u, v));
  };
  const auto of_patch = [&](int order_u, int order_v) {
    return value(exact_point(detail::rational_derivative(patch, order_u, order_v), u, v));
  };

  EXPECT_EQ(of(1, 0), of_patch(1, 0));
  EXPECT_EQ(of(2, 0), of_patch(2, 0));
  EXPECT_EQ((of(0, 1) - of(1, 0)) * u, of_patch(0, 1));
  EXPECT_EQ((of(0, 2) - of(1, 1) * Rational(2) + of(2, 0)) * Rational(u * u), of_patch(0, 2));
}

TEST_P(DerivativesProperty, OfRationalTrianglesAreWithinTheStatedError) {
  auto random = seeded(GetParam());
  const int n = pick(random, 0, 6), order = pick(random, 0, 2);
  const RationalBezierTriangle triangle = random_rational_triangle(random, n);

  const RationalBezierTriangle computed = rational_derivative(triangle, 1, order);
  const auto expected = detail::rational_derivative(exact(triangle), 1, order);

  ASSERT_EQ(computed.degree, (order + 2) * n);
  for (std::size_t k = 0; k < expected.points.size(); ++k)
    EXPECT_LE(exact_gap(computed.points[k], expected.points[k]),
              rational_triangle_derivative_error(n, order + 1));
}

TEST_P(DerivativesProperty, OfTrianglesAddUpToTheChangeAlongALine) {
  auto random = seeded(GetParam());
  const auto triangle = exact(random_triangle(random, pick(random, 0, 5)));
  const Rational x(1, 3), y(1, 5);

  // Taylor's series along x ends with the degree.
  auto term = triangle;
  auto sum = exact_point(triangle, x, y);
  Rational factor = 1;
  for (int k = 1; k <= triangle.degree; ++k) {
    term = detail::one_derivative(term, detail::By::U);
    factor /= 2 * k;
    sum += exact_point(term, x, y) * factor;
  }

  EXPECT_EQ(sum, exact_point(triangle, x + Rational(1, 2), y));
}

INSTANTIATE_TEST_SUITE_P(Seeds, DerivativesProperty, ::testing::Range(0, 20));

TEST(Derivatives, RefuseNegativeOrdersEmptyFormsAndTooHighDegrees) {
  EXPECT_THROW(derivative(BezierCurve{}, 1), InvalidInput);
  EXPECT_THROW(derivative(BezierCurve{{{0, 0, 0}}}, -1), InvalidInput);
  EXPECT_THROW(derivative(BezierTriangle{2, std::vector<Vec3>(5)}, 1, 0), InvalidInput);
  EXPECT_THROW(rational_derivative(RationalBezierCurve{std::vector<Vec4>(26)}, 2), InvalidInput);
  EXPECT_THROW(rational_derivative(RationalBezierTriangle{1, std::vector<Vec4>(2)}, 1, 0),
               InvalidInput);
  const RationalBezierTriangle high{25, std::vector<Vec4>(351)};
  EXPECT_THROW(rational_derivative(high, 1, 1), InvalidInput);
  EXPECT_THROW(rational_derivative(high, 0, -1), InvalidInput);
}

}  // namespace
}  // namespace blossom
