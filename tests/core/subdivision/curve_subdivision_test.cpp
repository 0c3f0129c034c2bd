// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/subdivision/curve_subdivision.h"

#include <gtest/gtest.h>

#include <array>

#include "core/base/errors.h"
#include "core/math/detail/bernstein.h"
#include "core/math/matrix.h"
#include "tests/support/exact.h"
#include "tests/support/shapes.h"

namespace blossom {
namespace {

using testing::exact;
using testing::exact_gap;
using testing::random_curve;
using testing::Rational;
using testing::seeded;
using testing::uniform;

const BezierCurve2 kParabola{{{0, 0}, {1, 2}, {2, 0}}};

TEST(CurveSubdivision, HalvesOfAParabolaAreKnownByHand) {
  const auto pieces = subdivide(kParabola, std::array{0.0, 0.5, 1.0});

  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_EQ(pieces[0].points, (std::vector<Vec2>{{0, 0}, {0.5, 1}, {1, 1}}));
  EXPECT_EQ(pieces[1].points, (std::vector<Vec2>{{1, 1}, {1.5, 1}, {2, 0}}));
}

TEST(CurveSubdivision, ReversesAndExtends) {
  EXPECT_EQ(sub_curve(kParabola, {1, 0}).points, (std::vector<Vec2>{{2, 0}, {1, 2}, {0, 0}}));
  EXPECT_EQ(sub_curve(kParabola, {1, 2}).points, (std::vector<Vec2>{{2, 0}, {3, -2}, {4, -8}}));
}

class CurveSubdivisionProperty : public ::testing::TestWithParam<int> {};

TEST_P(CurveSubdivisionProperty, PiecesAreTheExactOnesWithinTheStatedError) {
  auto random = seeded(GetParam());
  const int n = GetParam() % 26;
  const BezierCurve curve = random_curve(random, n);
  const Interval piece{uniform(random, 0, 1), uniform(random, 0, 1)};

  const BezierCurve computed = sub_curve(curve, piece);

  const IntervalOf<Rational> exact_piece{Rational(piece.from), Rational(piece.to)};
  const auto expected = product(detail::subdivision_matrix(n, exact_piece), exact(curve.points));
  for (std::size_t k = 0; k < expected.size(); ++k)
    EXPECT_LE(exact_gap(computed.points[k], expected[k]), curve_subdivision_error(n));
}

TEST_P(CurveSubdivisionProperty, NeighboursShareTheirEndBitForBit) {
  auto random = seeded(GetParam());
  const BezierCurve curve = random_curve(random, GetParam() % 26);

  const auto pieces = subdivide(curve, std::array{0.0, uniform(random, 0.1, 0.9), 1.0});

  EXPECT_EQ(pieces[0].points.back(), pieces[1].points.front());
}

INSTANTIATE_TEST_SUITE_P(Seeds, CurveSubdivisionProperty, ::testing::Range(0, 26));

TEST(CurveSubdivision, RejectsCutsThatDoNotIncreaseOrAreTooFew) {
  EXPECT_THROW(subdivide(kParabola, std::array{0.0, 0.0}), InvalidInput);
  EXPECT_THROW(subdivide(kParabola, std::array{0.0}), InvalidInput);
  EXPECT_THROW(sub_curve(BezierCurve{}, {0, 1}), InvalidInput);
}

}  // namespace
}  // namespace blossom
