// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blossom/triangle_composition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/errors.h"
#include "core/blossom/composition.h"
#include "core/blossom/triangle_blossom.h"
#include "core/forms/evaluation.h"
#include "core/subdivision/triangle_subdivision.h"
#include "tests/support/random.h"
#include "tests/support/shapes.h"

namespace blossom {
namespace {

using testing::seeded;
using testing::uniform;

RationalBezierPatch random_rational_patch(auto& random, int n, int m, bool rational) {
  RationalBezierPatch patch{Grid<Vec4>(n + 1, m + 1)};
  for (Vec4& p : patch.points.values()) {
    const double w = rational ? uniform(random, 0.5, 1.0) : 1.0;
    p = {w * uniform(random, -1, 1), w * uniform(random, -1, 1), w * uniform(random, -1, 1), w};
  }
  return patch;
}

BezierTriangle random_map(auto& random, int degree, bool rational) {
  BezierTriangle map{degree, std::vector<Vec3>(BezierTriangle::count(degree))};
  for (Vec3& p : map.points) {
    const double w = rational ? uniform(random, 0.5, 1.0) : 1.0;
    p = {w * uniform(random, 0, 1), w * uniform(random, 0, 1), w};
  }
  return map;
}

TEST(TriangleComposition, OfAStraightMapIsTheoremThree) {
  auto random = seeded(1);
  const RationalBezierPatch patch = random_rational_patch(random, 3, 2, true);
  const BezierTriangle map{1, {{0.1, 0.2, 1}, {0.3, 0.9, 1}, {0.8, 0.4, 1}}};

  const RationalBezierTriangle made = composition(patch, map);

  const RationalBezierTriangle expected =
      sub_triangle(patch, {Vec2{0.8, 0.4}, Vec2{0.3, 0.9}, Vec2{0.1, 0.2}});
  ASSERT_EQ(made.degree, 5);
  for (std::size_t k = 0; k < made.points.size(); ++k)
    EXPECT_LE(max_norm(made.points[k] - expected.points[k]),
              triangle_composition_error(3, 2, 1) + sub_triangle_error(3, 2));
}

// The bilinear patch (u, v, u v) over the quarter disc: u^2 + v^2 = 1 on the curved side.
TEST(TriangleComposition, CarriesARationalCircleExactly) {
  RationalBezierPatch patch{Grid<Vec4>(2, 2)};
  patch.points(0, 0) = {0, 0, 0, 1};
  patch.points(0, 1) = {0, 1, 0, 1};
  patch.points(1, 0) = {1, 0, 0, 1};
  patch.points(1, 1) = {1, 1, 1, 1};
  const double w = std::sqrt(0.5);
  BezierTriangle map{2, {{0, 0, 1}, {0, 0.5, 1}, {0, 1, 1}, {0.5, 0, 1}, {w, w, w}, {1, 0, 1}}};

  const RationalBezierTriangle made = composition(patch, map);

  const RationalBezierCurve side = side_of(made, 0, 1);
  for (const double t : {0.0, 0.1, 0.5, 0.7, 1.0}) {
    const Vec4 h = testing::reference_point(side, t);
    const Vec3 p = Vec3{h[0], h[1], h[2]} * (1 / h[3]);
    EXPECT_NEAR(p[0] * p[0] + p[1] * p[1], 1, 1e-15);
    EXPECT_NEAR(p[2], p[0] * p[1], 1e-15);
  }
}

TEST(TriangleComposition, RefusesDegreesThatAreTooHigh) {
  auto random = seeded(2);
  const RationalBezierPatch patch = random_rational_patch(random, 9, 9, false);
  EXPECT_THROW(composition(patch, random_map(random, 3, false)), InvalidInput);
  EXPECT_THROW(composition(patch, BezierTriangle{2, {}}), InvalidInput);
  EXPECT_THROW(turning_form(BezierTriangle{0, {{0, 0, 1}}}), InvalidInput);
}

TEST(TurningForm, OfAStraightMapIsTwiceItsArea) {
  const BezierTriangle map{1, {{0, 0, 1}, {0, 3, 1}, {2, 0, 1}}};  // c, b, a
  EXPECT_EQ(turning_form(map).points, (std::vector<double>{6}));
}

TEST(TurningForm, IsNegativeWhereAMapTurnsOver) {
  // The curved side bulges beyond the opposite corner.
  BezierTriangle map{2, {{0, 0, 1}, {0, 0.5, 1}, {0, 1, 1}, {0.5, 0, 1}, {-2, -2, 1}, {1, 0, 1}}};
  const BezierTriangleOf<double> turning = turning_form(map);
  EXPECT_LT(*std::ranges::min_element(turning.points), 0);
}

class TriangleCompositionProperty : public ::testing::TestWithParam<int> {};

TEST_P(TriangleCompositionProperty, LiesOnThePatchWithinTheStatedError) {
  auto random = seeded(GetParam());
  const int n = 1 + GetParam() % 3, m = 1 + GetParam() / 3 % 3, q = 1 + GetParam() / 9 % 4;
  const bool rational = GetParam() % 2 == 1;
  const RationalBezierPatch patch = random_rational_patch(random, n, m, rational);
  const BezierTriangle map = random_map(random, q, rational);

  const RationalBezierTriangle made = composition(patch, map);

  const double x = uniform(random, 0, 0.5), y = uniform(random, 0, 0.5);
  const Vec3 uv = blossom_at(map, std::vector<Vec2>(static_cast<std::size_t>(q), {x, y}));
  const Vec4 on_triangle =
      blossom_at(made, std::vector<Vec2>(static_cast<std::size_t>(made.degree), {x, y}));
  const Vec3 on_patch = point_at(patch, uv[0] / uv[2], uv[1] / uv[2]);
  const Vec3 projected =
      Vec3{on_triangle[0], on_triangle[1], on_triangle[2]} * (1 / on_triangle[3]);
  // Both evaluations round too, and a weight may be as small as 2^-(n + m + 1).
  const double error = triangle_composition_error(n, m, q) + 10 * made.degree * 0x1p-53;
  EXPECT_LE(max_norm(projected - on_patch), 4 * error * std::exp2(n + m + 1));
}

TEST_P(TriangleCompositionProperty, HasThePatchAlongTheSidesOfTheMap) {
  auto random = seeded(GetParam());
  const int n = 1 + GetParam() % 3, m = 1 + GetParam() / 3 % 3, q = 1 + GetParam() / 9 % 4;
  const RationalBezierPatch patch = random_rational_patch(random, n, m, true);
  const BezierTriangle map = random_map(random, q, true);

  const RationalBezierTriangle made = composition(patch, map);

  for (const auto& [from, to] : {std::pair{0, 1}, std::pair{1, 2}, std::pair{2, 0}}) {
    const RationalBezierCurve side = side_of(made, from, to);
    const RationalBezierCurve expected = composition(patch, side_of(map, from, to));
    for (std::size_t k = 0; k < side.points.size(); ++k)
      EXPECT_LE(max_norm(side.points[k] - expected.points[k]),
                triangle_composition_error(n, m, q) + composition_error(n, m, q));
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, TriangleCompositionProperty, ::testing::Range(0, 36));

}  // namespace
}  // namespace blossom
