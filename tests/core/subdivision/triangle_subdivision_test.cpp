// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/subdivision/triangle_subdivision.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/base/errors.h"
#include "core/forms/algebra/de_casteljau.h"
#include "core/subdivision/detail/triangle.h"
#include "tests/support/exact.h"
#include "tests/support/shapes.h"

namespace blossom {
namespace {

using testing::coordinate_gap;
using testing::exact;
using testing::exact_gap;
using testing::random_patch;
using testing::random_triangle;
using testing::Rational;
using testing::reference_point;
using testing::seeded;
using testing::uniform;

constexpr TriangleCorners kUnit{{{1, 0}, {0, 1}, {0, 0}}};

Vec2 in_square(testing::Random& random) { return {uniform(random, 0, 1), uniform(random, 0, 1)}; }

Vec2 in_triangle(testing::Random& random) {
  const double x = uniform(random, 0, 1);
  return {x, uniform(random, 0, 1 - x)};
}

TEST(TriangleSubdivision, HalfOfTheSaddleHasHandComputedNet) {
  BezierPatch saddle{Grid<Vec3>(2, 2)};
  saddle.points(0, 1) = {0, 1, 0};
  saddle.points(1, 0) = {1, 0, 0};
  saddle.points(1, 1) = {1, 1, 1};

  const BezierTriangle upper = sub_triangle(saddle, TriangleCorners{{{1, 0}, {0, 1}, {1, 1}}});

  EXPECT_EQ(upper(2, 0), (Vec3{1, 0, 0}));
  EXPECT_EQ(upper(0, 2), (Vec3{0, 1, 0}));
  EXPECT_EQ(upper(0, 0), (Vec3{1, 1, 1}));
  EXPECT_EQ(upper(1, 1), (Vec3{0.5, 0.5, 0.5}));
  EXPECT_EQ(upper(1, 0), (Vec3{1, 0.5, 0.5}));
}

class TriangleSubdivisionProperty : public ::testing::TestWithParam<int> {
 protected:
  int n() const { return GetParam() % 9; }
  int m() const { return GetParam() / 5; }
};

TEST_P(TriangleSubdivisionProperty, PointsAreTheExactOnesWithinTheStatedError) {
  auto random = seeded(GetParam());
  const int rows = GetParam() % 5, columns = GetParam() % 4;
  const BezierPatch patch = random_patch(random, rows, columns);
  const TriangleCorners corners{in_square(random), in_square(random), in_square(random)};

  const BezierTriangle computed = sub_triangle(patch, corners);

  const auto expected = detail::triangle_from_net(
      exact(patch.points),
      std::array<Vec<Rational, 2>, 3>{exact(corners[0]), exact(corners[1]), exact(corners[2])});
  for (std::size_t k = 0; k < expected.size(); ++k)
    EXPECT_LE(exact_gap(computed.points[k], expected[k]), sub_triangle_error(rows, columns));
}

TEST_P(TriangleSubdivisionProperty, TrianglesLieOnThePatch) {
  auto random = seeded(GetParam());
  const BezierPatch patch = random_patch(random, n(), m());
  const TriangleCorners corners{in_square(random), in_square(random), in_square(random)};
  const Vec2 xy = in_triangle(random);

  const BezierTriangle piece = sub_triangle(patch, corners);

  const Vec2 uv = corners[0] * xy[0] + corners[1] * xy[1] + corners[2] * (1 - xy[0] - xy[1]);
  EXPECT_LE(coordinate_gap(point_at(piece, xy[0], xy[1]), reference_point(patch, uv[0], uv[1])),
            sub_triangle_error(n(), m()) + inner_triangle_error(n() + m()));
}

TEST_P(TriangleSubdivisionProperty, TrianglesStayInTheConvexHull) {
  auto random = seeded(GetParam());
  BezierPatch patch = random_patch(random, n(), m());
  for (Vec3& point : patch.points.values()) point[2] = 1;

  const BezierTriangle piece =
      sub_triangle(patch, {in_square(random), in_square(random), in_square(random)});

  for (const Vec3& point : piece.points) EXPECT_NEAR(point[2], 1, sub_triangle_error(n(), m()));
}

TEST_P(TriangleSubdivisionProperty, InnerTrianglesLieOnTheTriangle) {
  auto random = seeded(GetParam());
  const int degree = GetParam() % 12;
  const BezierTriangle triangle = random_triangle(random, degree);
  const TriangleCorners corners{in_triangle(random), in_triangle(random), in_triangle(random)};
  const Vec2 xy = in_triangle(random);

  const BezierTriangle piece = sub_triangle(triangle, corners);

  const Vec2 at = corners[0] * xy[0] + corners[1] * xy[1] + corners[2] * (1 - xy[0] - xy[1]);
  EXPECT_LE(coordinate_gap(point_at(piece, xy[0], xy[1]), point_at(triangle, at[0], at[1])),
            3 * inner_triangle_error(degree) + 4 * degree * 0x1p-53);
}

INSTANTIATE_TEST_SUITE_P(Seeds, TriangleSubdivisionProperty, ::testing::Range(0, 45));

TEST(TriangleSubdivision, GoesToTheHighestDegrees) {
  auto random = seeded(1);
  const BezierPatch patch = random_patch(random, 25, 25);

  const BezierTriangle piece = sub_triangle(patch, kUnit);

  EXPECT_EQ(piece.degree, 50);
  EXPECT_LE(coordinate_gap(point_at(piece, 0.25, 0.5), reference_point(patch, 0.25, 0.5)),
            sub_triangle_error(25, 25) + inner_triangle_error(50));
}

TEST(TriangleSubdivision, OfTheSameTriangleChangesNothing) {
  auto random = seeded(2);
  const BezierTriangle triangle = random_triangle(random, 6);

  EXPECT_EQ(sub_triangle(triangle, kUnit), triangle);
}

TEST(TriangleSubdivision, RefusesCornersThatAreNotFiniteAndWrongNumbersOfPoints) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const BezierPatch point{Grid<Vec3>(1, 1)};
  EXPECT_THROW(sub_triangle(point, TriangleCorners{{{0, 0}, {nan, 0}, {0, 1}}}), InvalidInput);
  EXPECT_THROW(sub_triangle(BezierPatch{}, kUnit), InvalidInput);
  EXPECT_THROW(sub_triangle(BezierTriangle{2, std::vector<Vec3>(5)}, kUnit), InvalidInput);
}

}  // namespace
}  // namespace blossom
