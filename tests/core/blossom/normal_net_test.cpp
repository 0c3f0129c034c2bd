// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blossom/normal_net.h"

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "core/blossom/detail/normal_net.h"
#include "tests/core/forms/exact_forms.h"
#include "tests/support/shapes.h"

namespace blossom {
namespace {

using testing::exact;
using testing::exact_gap;
using testing::exact_point;
using testing::pick;
using testing::random_patch;
using testing::Rational;
using testing::seeded;
using testing::uniform;

TEST(NormalNet, OfTheSaddleIsKnownByHand) {
  // z = u v: the normal is (-v, -u, 1).
  BezierPatch saddle{Grid<Vec3>(2, 2)};
  saddle.points(0, 1) = {0, 1, 0};
  saddle.points(1, 0) = {1, 0, 0};
  saddle.points(1, 1) = {1, 1, 1};

  const BezierPatch normal = normal_net(saddle);

  ASSERT_EQ(normal.degree_u(), 1);
  ASSERT_EQ(normal.degree_v(), 1);
  EXPECT_EQ(normal.points(0, 0), (Vec3{0, 0, 1}));
  EXPECT_EQ(normal.points(1, 0), (Vec3{0, -1, 1}));
  EXPECT_EQ(normal.points(1, 1), (Vec3{-1, -1, 1}));
}

class NormalNetProperty : public ::testing::TestWithParam<int> {};

TEST_P(NormalNetProperty, OverRationalsIsTheCrossProductOfDerivatives) {
  auto random = seeded(GetParam());
  const auto net = exact(random_patch(random, pick(random, 1, 3), pick(random, 1, 3)).points);

  const auto normal = detail::normal_net(net);

  ASSERT_EQ(normal.rows(), 2 * net.rows() - 2);
  ASSERT_EQ(normal.columns(), 2 * net.columns() - 2);
  const auto along_u = detail::derivative_along_u(net), along_v = detail::derivative_along_v(net);
  for (int k = 0; k <= 6; ++k)
    for (int l = 0; l <= 6; ++l) {
      const Rational u(k, 5), v(l, 7);
      EXPECT_EQ(exact_point(normal, u, v),
                cross(exact_point(along_u, u, v), exact_point(along_v, u, v)));
    }
}

TEST_P(NormalNetProperty, OfRationalPatchesIsTheThirdPowerOfTheWeightTimesTheNormal) {
  auto random = seeded(GetParam());
  const auto net = exact(random_patch<Vec4>(random, pick(random, 1, 2), pick(random, 1, 2)).points);

  const auto normal = detail::normal_net(net);

  ASSERT_EQ(normal.rows(), 3 * net.rows() - 3);
  const auto along_u = detail::rational_derivative(net, 1, 0);
  const auto along_v = detail::rational_derivative(net, 0, 1);
  const Rational u(1, 3), v(2, 5);
  const auto a = exact_point(along_u, u, v), b = exact_point(along_v, u, v);
  const Rational w = exact_point(net, u, v)[3];
  const auto product =
      cross(Vec<Rational, 3>{a[0], a[1], a[2]}, Vec<Rational, 3>{b[0], b[1], b[2]});
  EXPECT_EQ(exact_point(normal, u, v) * w, product);
}

TEST_P(NormalNetProperty, InDoubleIsWithinTheStatedError) {
  auto random = seeded(GetParam());
  const int n = pick(random, 1, 5), m = pick(random, 1, 5);
  const BezierPatch patch = random_patch(random, n, m);
  const RationalBezierPatch rational = random_patch<Vec4>(random, n, m);

  const BezierPatch normal = normal_net(patch), rational_normal = normal_net(rational);
  const auto expected = detail::normal_net(exact(patch.points));
  const auto expected_rational = detail::normal_net(exact(rational.points));

  for (int i = 0; i < expected.rows(); ++i)
    for (int j = 0; j < expected.columns(); ++j)
      EXPECT_LE(exact_gap(normal.points(i, j), expected(i, j)), normal_net_error(n, m));
  for (int i = 0; i < expected_rational.rows(); ++i)
    for (int j = 0; j < expected_rational.columns(); ++j)
      EXPECT_LE(exact_gap(rational_normal.points(i, j), expected_rational(i, j)),
                rational_normal_net_error(n, m));
}

TEST_P(NormalNetProperty, OfWeightsOneIsThePolynomialOneRaised) {
  auto random = seeded(GetParam());
  const BezierPatch patch = random_patch(random, 2, 3);
  RationalBezierPatch rational{Grid<Vec4>(3, 4)};
  for (int i = 0; i <= 2; ++i)
    for (int j = 0; j <= 3; ++j) {
      const Vec3& p = patch.points(i, j);
      rational.points(i, j) = {p[0], p[1], p[2], 1};
    }
  const auto raised = detail::elevated_net(detail::normal_net(exact(patch.points)), 2, 3);
  const auto normal = detail::normal_net(exact(rational.points));

  EXPECT_EQ(normal, raised);
}

INSTANTIATE_TEST_SUITE_P(Seeds, NormalNetProperty, ::testing::Range(0, 25));

TEST(NormalNet, RefusesDegreesWithoutNormal) {
  EXPECT_THROW(normal_net(BezierPatch{Grid<Vec3>(1, 3)}), InvalidInput);
  EXPECT_THROW(normal_net(BezierPatch{}), InvalidInput);
  EXPECT_THROW(normal_net(RationalBezierPatch{Grid<Vec4>(22, 2)}), InvalidInput);
}

}  // namespace
}  // namespace blossom
