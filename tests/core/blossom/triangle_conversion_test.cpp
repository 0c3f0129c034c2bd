// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blossom/triangle_conversion.h"

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "core/blossom/detail/triangle_conversion.h"
#include "core/blossom/triangle_blossom.h"
#include "core/forms/algebra/degree.h"
#include "tests/core/forms/exact_forms.h"
#include "tests/support/shapes.h"

namespace blossom {
namespace {

using testing::exact;
using testing::exact_gap;
using testing::exact_point;
using testing::pick;
using testing::random_patch;
using testing::random_triangle;
using testing::Rational;
using testing::reference_point;
using testing::seeded;
using testing::uniform;

// Vertices a = (1, 0), b = (0, 1), c = (0, 0): the triangle shows its own barycentric (x, y).
const BezierTriangle kFlat{1, {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}};

TEST(TriangleConversion, OfAFlatTriangleCollapsesOneSide) {
  const BezierPatch patch = collapsed_patch(kFlat);

  EXPECT_EQ(patch.points(0, 0), (Vec3{0, 0, 0}));
  EXPECT_EQ(patch.points(0, 1), (Vec3{0, 0, 0}));
  EXPECT_EQ(patch.points(1, 0), (Vec3{1, 0, 0}));
  EXPECT_EQ(patch.points(1, 1), (Vec3{0, 1, 0}));
}

TEST(TriangleConversion, OfAFlatTriangleGivesThreeQuadsRoundItsMiddle) {
  const auto quads = three_quads(kFlat);

  EXPECT_EQ(quads[0].points(0, 0), (Vec3{1, 0, 0}));
  EXPECT_EQ(quads[0].points(1, 0), (Vec3{0.5, 0.5, 0}));
  EXPECT_EQ(quads[0].points(0, 1), (Vec3{0.5, 0, 0}));
  EXPECT_EQ(quads[1].points(0, 0), (Vec3{0, 1, 0}));
  EXPECT_EQ(quads[1].points(1, 0), (Vec3{0, 0.5, 0}));
  EXPECT_EQ(quads[2].points(0, 0), (Vec3{0, 0, 0}));
  EXPECT_EQ(quads[2].points(1, 0), (Vec3{0.5, 0, 0}));
  for (const BezierPatch& quad : quads) EXPECT_NEAR(quad.points(1, 1)[0], 1.0 / 3, 1e-16);
}

class TriangleConversionProperty : public ::testing::TestWithParam<int> {};

TEST_P(TriangleConversionProperty, CollapsedOverRationalsIsTheTriangleExactly) {
  auto random = seeded(GetParam());
  const auto triangle = exact(random_triangle(random, pick(random, 0, 5)));

  const auto net = detail::collapsed_net(triangle);

  for (int k = 0; k <= 6; ++k)
    for (int l = 0; l <= 6; ++l) {
      const Rational u(k, 5), v(l, 7);
      EXPECT_EQ(exact_point(net, u, v), exact_point(triangle, u * (1 - v), u * v));
    }
}

TEST_P(TriangleConversionProperty, HalfAPatchOverRationalsIsTheTriangleExactly) {
  auto random = seeded(GetParam());
  const auto triangle = exact(random_triangle(random, pick(random, 0, 5)));

  const auto net = detail::half_net(triangle);

  for (int k = 0; k <= 6; ++k)
    for (int l = 0; l <= 6; ++l) {
      const Rational u(k, 5), v(l, 7);
      EXPECT_EQ(exact_point(net, u, v), exact_point(triangle, u, v));
    }
}

TEST_P(TriangleConversionProperty, HalfAPatchHasTwoSidesBitForBitAndTheThirdWithinItsError) {
  auto random = seeded(GetParam());
  const int n = pick(random, 1, 12);
  const BezierTriangle triangle = random_triangle(random, n);

  const BezierPatch patch = half_patch(triangle);

  for (int i = 0; i <= n; ++i) {
    EXPECT_EQ(patch.points(i, 0), triangle(i, 0));
    EXPECT_EQ(patch.points(0, i), triangle(0, i));
  }
  const auto net = exact(patch.points);
  for (int k = 0; k <= 8; ++k) {
    const Rational u(k, 8), v = 1 - u;
    EXPECT_LE(
        max_norm(testing::rounded(exact_point(exact(triangle), u, v) - exact_point(net, u, v))),
        half_patch_error(n));
  }
}

TEST_P(TriangleConversionProperty, QuadsOverRationalsAreTheTriangleExactly) {
  auto random = seeded(GetParam());
  const auto triangle = exact(random_triangle(random, pick(random, 0, 4)));
  detail::QuadCorners<Rational> corners;
  for (auto& corner : corners) corner = exact(Vec2{uniform(random, -1, 1), uniform(random, -1, 1)});

  const auto net = detail::quad_net(triangle, corners);

  for (int k = 0; k <= 5; ++k)
    for (int l = 0; l <= 5; ++l) {
      const Rational u(k, 5), v(l, 7);
      const auto low =
          corners[0] * Rational((1 - u) * (1 - v)) + corners[1] * Rational((1 - u) * v);
      const auto xy = low + corners[2] * Rational(u * (1 - v)) + corners[3] * Rational(u * v);
      EXPECT_EQ(exact_point(net, u, v), exact_point(triangle, xy[0], xy[1]));
    }
}

TEST_P(TriangleConversionProperty, InDoubleIsWithinTheStatedErrors) {
  auto random = seeded(GetParam());
  const int n = pick(random, 0, 7);
  const BezierTriangle triangle = random_triangle(random, n);
  const Rational half(1, 2), third(1, 3);
  const detail::QuadCorners<Rational> at_a{{{1, 0}, {half, 0}, {half, half}, {third, third}}};
  const detail::QuadCorners<Rational> at_b{{{0, 1}, {half, half}, {0, half}, {third, third}}};
  const detail::QuadCorners<Rational> at_c{{{0, 0}, {0, half}, {half, 0}, {third, third}}};

  const BezierPatch collapsed = collapsed_patch(triangle);
  const auto quads = three_quads(triangle);
  const auto expected = detail::collapsed_net(exact(triangle));
  const std::array expected_quads{detail::quad_net(exact(triangle), at_a),
                                  detail::quad_net(exact(triangle), at_b),
                                  detail::quad_net(exact(triangle), at_c)};

  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      EXPECT_LE(exact_gap(collapsed.points(i, j), expected(i, j)), elevation_error(n));
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_LE(exact_gap(quads[k].points(i, j), expected_quads[k](i, j)), three_quads_error(n));
    }
}

TEST_P(TriangleConversionProperty, NeighbouringQuadsShareTheirSides) {
  auto random = seeded(GetParam());
  const int n = pick(random, 1, 6);
  const auto quads = three_quads(random_triangle(random, n));

  for (std::size_t k = 0; k < 3; ++k)
    for (int i = 0; i <= n; ++i) {
      // From the middle of a side (u = 1, v = 0) inwards, and the next quad's (0, 1) inwards.
      const Vec3 gap = quads[k].points(n, i) - quads[(k + 1) % 3].points(i, n);
      EXPECT_LE(max_norm(gap), 2 * three_quads_error(n));
    }
}

TEST_P(TriangleConversionProperty, BackGivesTheTriangleAndASmallError) {
  auto random = seeded(GetParam());
  const BezierTriangle triangle = random_triangle(random, pick(random, 1, 8));

  const TriangleOfPatch<Vec3> back = triangle_of(collapsed_patch(triangle));

  ASSERT_EQ(back.triangle.degree, triangle.degree);
  for (std::size_t k = 0; k < triangle.points.size(); ++k)
    EXPECT_LE(max_norm(back.triangle.points[k] - triangle.points[k]), 1e-11);
  EXPECT_LE(back.error, 1e-13);
}

TEST_P(TriangleConversionProperty, BackStaysWithinItsErrorWherePatchesAreNoTriangles) {
  auto random = seeded(GetParam());
  const BezierPatch patch = random_patch(random, pick(random, 0, 4), pick(random, 0, 5));

  const TriangleOfPatch<Vec3> found = triangle_of(patch);

  const BezierPatch shown = collapsed_patch(found.triangle);
  for (int k = 0; k <= 8; ++k) {
    const double u = k / 8.0, v = 1 - u * u;
    EXPECT_LE(distance(reference_point(shown, u, v), reference_point(patch, u, v)),
              found.error + 1e-14);
  }
  EXPECT_GT(found.error, patch.degree_v() > 0 ? 1e-3 : -1);
}

TEST_P(TriangleConversionProperty, BlossomsOfTrianglesAreSymmetricAndDiagonal) {
  auto random = seeded(GetParam());
  const BezierTriangle triangle = random_triangle(random, 4);
  std::vector<Vec2> arguments;
  for (int k = 0; k < 4; ++k) arguments.push_back({uniform(random, 0, 1), uniform(random, 0, 1)});
  const Vec3 value = blossom_at(triangle, arguments);
  std::reverse(arguments.begin(), arguments.end());
  const std::vector<Vec2> same(4, arguments[0]);

  EXPECT_LE(max_norm(blossom_at(triangle, arguments) - value), 1e-13);
  const auto expected = exact_point(exact(triangle), Rational(same[0][0]), Rational(same[0][1]));
  EXPECT_LE(exact_gap(blossom_at(triangle, same), expected), 1e-13);
  EXPECT_EQ(blossom_at(triangle, std::vector<Vec2>{{1, 0}, {1, 0}, {0, 1}, {0, 0}}),
            triangle(2, 1));
}

INSTANTIATE_TEST_SUITE_P(Seeds, TriangleConversionProperty, ::testing::Range(0, 25));

TEST(TriangleConversion, RefusesWrongCounts) {
  const BezierTriangle wrong{2, std::vector<Vec3>(5)};
  EXPECT_THROW(collapsed_patch(wrong), InvalidInput);
  EXPECT_THROW(three_quads(wrong), InvalidInput);
  EXPECT_THROW(triangle_of(BezierPatch{}), InvalidInput);
  EXPECT_THROW(blossom_at(wrong, std::vector<Vec2>(2)), InvalidInput);
  EXPECT_THROW(blossom_at(kFlat, std::vector<Vec2>(2)), InvalidInput);
}

}  // namespace
}  // namespace blossom
