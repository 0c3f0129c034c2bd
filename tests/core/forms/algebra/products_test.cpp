// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/algebra/products.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/errors.h"
#include "core/forms/algebra/detail/products.h"
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
using testing::Rational;
using testing::seeded;
using testing::uniform;

BezierFunction random_function(testing::Random& random, int degree) {
  BezierFunction f;
  for (int k = 0; k <= degree; ++k) f.points.push_back(uniform(random, -1, 1));
  return f;
}

BezierFunction2 random_function2(testing::Random& random, int degree_u, int degree_v) {
  BezierFunction2 f{Grid<double>(degree_u + 1, degree_v + 1)};
  for (double& value : f.points.values()) value = uniform(random, -1, 1);
  return f;
}

TEST(Products, OfLinearFunctionsAreKnownByHand) {
  // (1 + t)(3 - 2t) = 3 + t - 2 t^2.
  EXPECT_EQ(product(BezierFunction{{1, 2}}, BezierFunction{{3, 1}}).points,
            (std::vector<double>{3, 3.5, 2}));
  // u v and its square.
  BezierFunction2 uv{Grid<double>(2, 2, 0.0)};
  uv.points(1, 1) = 1;
  const BezierFunction2 square = product(uv, uv);
  EXPECT_EQ(square.points(2, 2), 1);
  EXPECT_EQ(square.points(1, 1), 0);
  EXPECT_EQ(square.degree_u(), 2);
}

TEST(Products, OfCurvesAreKnownByHand) {
  const BezierCurve line{{{0, 0, 0}, {1, 0, 0}}}, other{{{0, 1, 0}, {0, 1, 1}}};

  // (t, 0, 0) x (0, 1, t) = (0, -t^2, t); the dot product is 0.
  EXPECT_EQ(cross_product(line, other).points,
            (std::vector<Vec3>{{0, 0, 0}, {0, 0, 0.5}, {0, -1, 1}}));
  EXPECT_EQ(dot_product(line, other).points, (std::vector<double>{0, 0, 0}));
  EXPECT_EQ(product(BezierFunction{{2}}, line).points, (std::vector<Vec3>{{0, 0, 0}, {2, 0, 0}}));
}

class ProductsProperty : public ::testing::TestWithParam<int> {};

TEST_P(ProductsProperty, OverRationalsAreProductsOfValues) {
  auto random = seeded(GetParam());
  const auto f = exact(random_patch(random, pick(random, 0, 3), pick(random, 0, 3)).points);
  const auto g = exact(random_patch(random, pick(random, 0, 3), pick(random, 0, 3)).points);
  const auto crossed = detail::cross_product(f, g);
  const auto dotted = detail::dot_product(f, g);

  for (int k = 0; k <= 6; ++k)
    for (int l = 0; l <= 6; ++l) {
      const Rational u(k, 5), v(l, 7);
      const auto a = exact_point(f, u, v), b = exact_point(g, u, v);
      EXPECT_EQ(exact_point(crossed, u, v), cross(a, b));
      EXPECT_EQ(exact_point(dotted, u, v), dot(a, b));
    }
}

TEST_P(ProductsProperty, OfCurvesAreWithinTheStatedError) {
  auto random = seeded(GetParam());
  const int n = pick(random, 0, 30), m = pick(random, 0, 30);
  const BezierFunction f = random_function(random, n);
  const BezierCurve g = random_curve(random, m), h = random_curve(random, n);
  const auto ours = detail::one_row(exact(g.points));

  const auto scaled_curve = detail::scalar_product(detail::one_row(exact(f.points)), ours);
  const auto dotted = detail::dot_product(detail::one_row(exact(h.points)), ours);
  const auto crossed = detail::cross_product(detail::one_row(exact(h.points)), ours);

  const double bound = product_error(0, std::min(n, m)), ulp = 0x1p-53;
  for (int k = 0; k <= n + m; ++k) {
    const auto at = static_cast<std::size_t>(k);
    EXPECT_LE(exact_gap(product(f, g).points[at], scaled_curve(0, k)), bound);
    EXPECT_LE(exact_gap(dot_product(h, g).points[at], dotted(0, k)), 3 * (bound + 3 * ulp));
    EXPECT_LE(exact_gap(cross_product(h, g).points[at], crossed(0, k)), 2 * (bound + ulp));
  }
}

TEST_P(ProductsProperty, OfPatchesAreWithinTheStatedError) {
  auto random = seeded(GetParam());
  const int n = pick(random, 0, 4), m = pick(random, 0, 4);
  const BezierFunction2 f = random_function2(random, n, m);
  const RationalBezierPatch g = random_patch<Vec4>(random, m, n);

  const RationalBezierPatch computed = product(f, g);
  const auto expected = detail::scalar_product(exact(f.points), exact(g.points));

  const double bound = product_error(std::min(n, m), std::min(n, m));
  for (int i = 0; i <= n + m; ++i)
    for (int j = 0; j <= n + m; ++j)
      EXPECT_LE(exact_gap(computed.points(i, j), expected(i, j)), bound);
}

TEST_P(ProductsProperty, CommuteForFunctions) {
  auto random = seeded(GetParam());
  const BezierFunction f = random_function(random, 5), g = random_function(random, 5);
  const BezierFunction one = product(f, g), other = product(g, f);

  for (std::size_t k = 0; k < one.points.size(); ++k)
    EXPECT_NEAR(one.points[k], other.points[k], 2 * product_error(0, 5));
}

INSTANTIATE_TEST_SUITE_P(Seeds, ProductsProperty, ::testing::Range(0, 30));

TEST(Products, RefuseEmptyFormsAndTooHighDegrees) {
  EXPECT_THROW(product(BezierFunction{}, BezierFunction{{1}}), InvalidInput);
  const BezierCurve high{std::vector<Vec3>(32)};
  EXPECT_THROW(cross_product(high, high), InvalidInput);
  EXPECT_THROW(dot_product(BezierPatch{}, BezierPatch{Grid<Vec3>(2, 2)}), InvalidInput);
}

}  // namespace
}  // namespace blossom
