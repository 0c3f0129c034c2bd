// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/subdivision/patch_subdivision.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>

#include "core/base/errors.h"
#include "core/forms/algebra/conversion.h"
#include "core/math/detail/bernstein.h"
#include "core/math/matrix.h"
#include "tests/support/exact.h"
#include "tests/support/shapes.h"

namespace blossom {
namespace {

using testing::coordinate_gap;
using testing::exact;
using testing::exact_gap;
using testing::lerp;
using testing::random_patch;
using testing::Rational;
using testing::reference_point;
using testing::seeded;
using testing::uniform;

constexpr std::array kWhole{0.0, 1.0};
constexpr std::array kHalves{0.0, 0.5, 1.0};

// The saddle z = x y over the unit square: every cell is known by hand.
BezierPatch saddle() {
  BezierPatch patch{Grid<Vec3>(2, 2)};
  patch.points(0, 1) = {0, 1, 0};
  patch.points(1, 0) = {1, 0, 0};
  patch.points(1, 1) = {1, 1, 1};
  return patch;
}

TEST(PatchSubdivision, QuarterOfSaddleHasHandComputedNet) {
  const Grid<BezierPatch> cells = subdivide(saddle(), kHalves, kHalves);

  ASSERT_EQ(cells.rows(), 2);
  ASSERT_EQ(cells.columns(), 2);
  EXPECT_EQ(cells(1, 1).points(0, 0), (Vec3{0.5, 0.5, 0.25}));
  EXPECT_EQ(cells(1, 1).points(0, 1), (Vec3{0.5, 1.0, 0.5}));
  EXPECT_EQ(cells(1, 1).points(1, 1), (Vec3{1.0, 1.0, 1.0}));
}

TEST(PatchSubdivision, ReachesBeyondThePatch) {
  const BezierPatch beyond = sub_patch(saddle(), {1, 3}, {2, -1});

  EXPECT_EQ(beyond.points(0, 0), (Vec3{1, 2, 2}));
  EXPECT_EQ(beyond.points(1, 0), (Vec3{3, 2, 6}));
  EXPECT_EQ(beyond.points(1, 1), (Vec3{3, -1, -3}));
}

class PatchSubdivisionProperty : public ::testing::TestWithParam<int> {
 protected:
  int n() const { return GetParam() % 26; }
  int m() const { return GetParam() * 7 % 26; }
};

TEST_P(PatchSubdivisionProperty, CellsLieOnThePatchWithinTheStatedError) {
  auto random = seeded(GetParam());
  const BezierPatch patch = random_patch(random, n(), m());
  const std::array u{0.0, uniform(random, 0.1, 0.9), 1.0};
  const std::array v{0.0, uniform(random, 0.1, 0.9), 1.0};

  const Grid<BezierPatch> cells = subdivide(patch, u, v);

  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      const auto k = static_cast<std::size_t>(i), l = static_cast<std::size_t>(j);
      const double s = uniform(random, 0.0, 1.0), t = uniform(random, 0.0, 1.0);
      const Vec3 on_cell = reference_point(cells(i, j), s, t);
      const Vec3 on_patch =
          reference_point(patch, lerp(u[k], u[k + 1], s), lerp(v[l], v[l + 1], t));
      EXPECT_LE(coordinate_gap(on_cell, on_patch), subdivision_error(std::max(n(), m())));
    }
}

TEST_P(PatchSubdivisionProperty, NetsAreTheExactOnesWithinTheStatedError) {
  auto random = seeded(GetParam());
  const int rows = GetParam() % 9, columns = GetParam() % 7;
  const RationalBezierPatch patch = random_patch<Vec4>(random, rows, columns);
  const Interval u{uniform(random, 0, 1), uniform(random, 0, 1)};
  const Interval v{uniform(random, 0, 1), uniform(random, 0, 1)};

  const RationalBezierPatch piece = sub_patch(patch, u, v);

  const auto along_u =
      detail::subdivision_matrix(rows, IntervalOf<Rational>{Rational(u.from), Rational(u.to)});
  const auto along_v =
      detail::subdivision_matrix(columns, IntervalOf<Rational>{Rational(v.from), Rational(v.to)});
  const auto expected = product_transposed(product(along_u, exact(patch.points)), along_v);
  for (int i = 0; i <= rows; ++i)
    for (int j = 0; j <= columns; ++j)
      EXPECT_LE(exact_gap(piece.points(i, j), expected(i, j)),
                subdivision_error(std::max(rows, columns)));
}

TEST_P(PatchSubdivisionProperty, NeighboursShareTheirBordersBitForBit) {
  auto random = seeded(GetParam());
  const BezierPatch patch = random_patch(random, 3, 4);
  const std::array u{0.0, uniform(random, 0.1, 0.9), 1.0};
  const std::array v{0.0, uniform(random, 0.1, 0.9), 1.0};

  const Grid<BezierPatch> cells = subdivide(patch, u, v);

  for (int j = 0; j <= 4; ++j) EXPECT_EQ(cells(0, 0).points(3, j), cells(1, 0).points(0, j));
  for (int i = 0; i <= 3; ++i) EXPECT_EQ(cells(1, 0).points(i, 4), cells(1, 1).points(i, 0));
}

TEST_P(PatchSubdivisionProperty, NeighbouringPatchesStayJoinedBitForBit) {
  auto random = seeded(GetParam());
  const BezierPatch left = random_patch(random, 3, 5);
  BezierPatch right = random_patch(random, 3, 5);
  for (int j = 0; j <= 5; ++j) right.points(0, j) = left.points(3, j);
  const std::array u{0.0, 0.5, 1.0};
  const std::array v{0.0, uniform(random, 0.1, 0.9), 1.0};

  const auto left_cells = subdivide(left, u, v), right_cells = subdivide(right, u, v);

  for (int j = 0; j <= 5; ++j)
    EXPECT_EQ(left_cells(1, 0).points(3, j), right_cells(0, 0).points(0, j));
}

TEST_P(PatchSubdivisionProperty, ASubPatchIsTheCellOfTheGrid) {
  auto random = seeded(GetParam());
  const BezierPatch patch = random_patch(random, 2, 3);
  const std::array u{0.0, uniform(random, 0.1, 0.9), 1.0};

  EXPECT_EQ(sub_patch(patch, {u[1], u[2]}, {0, 1}), subdivide(patch, u, kWhole)(1, 0));
}

INSTANTIATE_TEST_SUITE_P(Seeds, PatchSubdivisionProperty, ::testing::Range(0, 26));

TEST(PatchSubdivision, RejectsCutsThatDoNotIncrease) {
  EXPECT_THROW(subdivide(saddle(), std::array{0.0, 0.5, 0.5}, kWhole), InvalidInput);
  EXPECT_THROW(subdivide(saddle(), kWhole, std::array{1.0, 0.0}), InvalidInput);
}

TEST(PatchSubdivision, RejectsTooFewCutsAndWhatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(subdivide(saddle(), std::array{0.5}, kWhole), InvalidInput);
  EXPECT_THROW(subdivide(saddle(), std::array{0.0, nan}, kWhole), InvalidInput);
  EXPECT_THROW(sub_patch(saddle(), {0, nan}, {0, 1}), InvalidInput);
  EXPECT_THROW(sub_patch(BezierPatch{}, {0, 1}, {0, 1}), InvalidInput);
}

}  // namespace
}  // namespace blossom
