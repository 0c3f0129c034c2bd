// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blossom/triangle_blossom.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "core/base/errors.h"
#include "core/forms/algebra/de_casteljau.h"
#include "tests/support/shapes.h"

namespace blossom {
namespace {

using testing::coordinate_gap;
using testing::random_monomial_patch;
using testing::reference_point;
using testing::seeded;
using testing::uniform;

constexpr TriangleCorners kUnit{{{1, 0}, {0, 1}, {0, 0}}};

// z = u v.
MonomialPatch monomial_saddle() {
  MonomialPatch patch{Grid<Vec3>(2, 2)};
  patch.coefficients(1, 0) = {1, 0, 0};
  patch.coefficients(0, 1) = {0, 1, 0};
  patch.coefficients(1, 1) = {0, 0, 1};
  return patch;
}

TEST(TriangleBlossom, OfTheSaddleIsTheAverageOfTheTwoProducts) {
  const std::array<Vec2, 2> arguments{{{2, 3}, {5, 7}}};

  EXPECT_EQ(blossom_at(monomial_saddle(), arguments), (Vec3{3.5, 5, (2 * 7 + 5 * 3) / 2.0}));
}

TEST(TriangleBlossom, GivesTheNetOfTheSaddleOnTheUnitTriangle) {
  const BezierTriangle net = bezier_points(monomial_saddle(), kUnit);

  EXPECT_EQ(net.degree, 2);
  EXPECT_EQ(net(2, 0), (Vec3{1, 0, 0}));
  EXPECT_EQ(net(0, 2), (Vec3{0, 1, 0}));
  EXPECT_EQ(net(0, 0), (Vec3{0, 0, 0}));
  EXPECT_EQ(net(1, 1), (Vec3{0.5, 0.5, 0.5}));
  EXPECT_EQ(net(1, 0), (Vec3{0.5, 0, 0}));
}

class TriangleBlossomProperty : public ::testing::TestWithParam<int> {
 protected:
  int n() const { return GetParam() % 5; }
  int m() const { return GetParam() / 5 % 4; }
  int degree() const { return n() + m(); }
  double error() const { return triangle_blossom_error(degree(), n(), m()); }
  static Vec2 parameters(testing::Random& random) {
    return {uniform(random, 0, 1), uniform(random, 0, 1)};
  }
};

TEST_P(TriangleBlossomProperty, PointsAreThoseOfTheSurface) {
  auto random = seeded(GetParam());
  MonomialPatch patch = random_monomial_patch(random, n(), m());
  patch.centre_u = uniform(random, -1, 1);
  patch.scale_v = uniform(random, 0.5, 2);
  const TriangleCorners corners{parameters(random), parameters(random), parameters(random)};
  const auto [a, b, c] = corners;
  const double x = uniform(random, 0, 0.5), y = uniform(random, 0, 0.5), z = 1 - x - y;

  const BezierTriangle piece = bezier_points(patch, corners);

  const Vec2 uv = a * x + b * y + c * z;
  EXPECT_LE(coordinate_gap(point_at(piece, x, y), reference_point(patch, uv[0], uv[1])),
            2 * error() * triangle_scale(patch, corners, degree()));
}

TEST_P(TriangleBlossomProperty, PointsAreBlossomsAtRepeatedCorners) {
  auto random = seeded(GetParam());
  const MonomialPatch patch = random_monomial_patch(random, n(), m());
  const TriangleCorners corners{parameters(random), parameters(random), parameters(random)};

  const BezierTriangle piece = bezier_points(patch, corners);

  for (int nu = 0; nu <= degree(); ++nu)
    for (int mu = 0; nu + mu <= degree(); ++mu) {
      std::vector<Vec2> arguments(static_cast<std::size_t>(nu), corners[0]);
      arguments.insert(arguments.end(), static_cast<std::size_t>(mu), corners[1]);
      arguments.resize(static_cast<std::size_t>(degree()), corners[2]);
      std::shuffle(arguments.begin(), arguments.end(), random);
      EXPECT_LE(coordinate_gap(piece(nu, mu), blossom_at(patch, arguments)),
                2 * error() * triangle_scale(patch, corners, degree()));
    }
}

TEST_P(TriangleBlossomProperty, SwappingTwoCornersSwapsTheirIndices) {
  auto random = seeded(GetParam());
  const MonomialPatch patch = random_monomial_patch(random, n(), m());
  const TriangleCorners corners{parameters(random), parameters(random), parameters(random)};
  const TriangleCorners swapped{corners[1], corners[0], corners[2]};

  const BezierTriangle piece = bezier_points(patch, corners);
  const BezierTriangle other = bezier_points(patch, swapped);

  for (int nu = 0; nu <= degree(); ++nu)
    for (int mu = 0; nu + mu <= degree(); ++mu)
      EXPECT_LE(coordinate_gap(piece(nu, mu), other(mu, nu)),
                2 * error() * triangle_scale(patch, corners, degree()));
}

TEST_P(TriangleBlossomProperty, AHigherDegreeIsTheSameSurface) {
  auto random = seeded(GetParam());
  const MonomialPatch patch = random_monomial_patch(random, n(), m());

  const BezierTriangle raised = bezier_points(patch, kUnit, degree() + 2);

  EXPECT_LE(coordinate_gap(point_at(raised, 0.25, 0.5), reference_point(patch, 0.25, 0.5)),
            2 * triangle_blossom_error(degree() + 2, n(), m()) *
                triangle_scale(patch, kUnit, degree() + 2));
}

INSTANTIATE_TEST_SUITE_P(Seeds, TriangleBlossomProperty, ::testing::Range(0, 40));

TEST(TriangleBlossom, IsOnePointOverATriangleOfOnePoint) {
  const BezierTriangle piece =
      bezier_points(monomial_saddle(), TriangleCorners{{{0.5, 2}, {0.5, 2}, {0.5, 2}}});

  for (const Vec3& point : piece.points) EXPECT_EQ(point, (Vec3{0.5, 2, 1}));
}

TEST(TriangleBlossom, RefusesADegreeThatLosesACoefficient) {
  try {
    bezier_points(monomial_saddle(), kUnit, 1);
    FAIL() << "degree 1 was accepted for u v";
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(),
                 "bezier_points: the degree 1 is too low for the coefficient (1, 1), "
                 "which is not 0");
  }
}

TEST(TriangleBlossom, RefusesCornersThatAreNotFiniteAndDegreesThatAreTooHigh) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(bezier_points(monomial_saddle(), TriangleCorners{{{0, 0}, {1, nan}, {0, 1}}}),
               InvalidInput);
  EXPECT_THROW(bezier_points(monomial_saddle(), kUnit, 26), InvalidInput);
  EXPECT_THROW(blossom_at(monomial_saddle(), std::vector<Vec2>(51)), InvalidInput);
}

}  // namespace
}  // namespace blossom
