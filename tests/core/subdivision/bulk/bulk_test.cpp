// SPDX-License-Identifier: LGPL-2.1-or-later
// Bulk subdivision of nets against exact rationals, against itself in other shapes, and what it
// refuses.

#include "core/subdivision/bulk/bulk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "core/base/errors.h"
#include "tests/core/subdivision/bulk/bulk_samples.h"
#include "tests/support/exact.h"
#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::all_levels;
using testing::dyadic;
using testing::exact_blossom;
using testing::exact_gap;
using testing::exact_row;
using testing::level_name;
using testing::pick;
using testing::random_net;
using testing::Rational;
using testing::seeded;
using testing::sum_of_plane;
using testing::uniform;

constexpr std::array kHalves{0.0, 0.5, 1.0};

// x = u, y = v, z = u v: every piece is known by hand.
const NetShape kSaddleShape{2, 2, 3};
const LaneVector kSaddle{0, 0, 1, 1, 0, 1, 0, 1, 0, 0, 0, 1};

// The n arguments of the blossom that give control point k of a piece.
std::vector<double> arguments(const Interval& piece, int n, int k) {
  std::vector<double> result(static_cast<std::size_t>(n), piece.from);
  std::fill_n(result.begin(), k, piece.to);
  return result;
}

// The largest error of some control points of a plane, first and last among them.
double largest_gap(NetForm form, const NetShape& shape, const LaneVector& net,
                   const LaneVector& found, int plane, const Interval& u, const Interval& v) {
  const int n = shape.rows - 1, m = shape.columns - 1;
  const int samples[][2] = {{0, 0}, {n, m}, {n / 2, m / 2}, {n / 3, m - m / 3}};
  double largest = 0;
  for (const auto& [k, l] : samples) {
    const Rational expected =
        exact_blossom(form, shape, net, plane, arguments(u, n, k), arguments(v, m, l));
    const int place = plane * shape.plane_size() + k * shape.columns + l;
    largest = std::max(largest, exact_gap(found[static_cast<std::size_t>(place)], expected));
  }
  return largest;
}

// A piece of width 2^-exponent inside [0, 1].
Interval narrow_piece(testing::Random& random, int exponent) {
  const double width = std::ldexp(1.0, -exponent);
  const double from = std::min(dyadic(random, std::max(exponent, 4)), 1 - width);
  return {from, from + width};
}

// Ends of kLanes pieces, kept alive beside the spans.
struct Ends {
  LaneVector u_from, u_to, v_from, v_to;

  void add(const Interval& u, const Interval& v) {
    u_from.push_back(u.from);
    u_to.push_back(u.to);
    v_from.push_back(v.from);
    v_to.push_back(v.to);
  }
  PieceEnds spans() const { return {u_from, u_to, v_from, v_to}; }
  Interval u(std::size_t k) const { return {u_from[k], u_to[k]}; }
  Interval v(std::size_t k) const { return {v_from[k], v_to[k]}; }
};

Ends random_ends(testing::Random& random, int count) {
  Ends ends;
  for (int k = 0; k < count; ++k)
    ends.add(narrow_piece(random, pick(random, 0, 40)), narrow_piece(random, pick(random, 0, 40)));
  return ends;
}

LaneVector net_of_block(const NetShape& shape, const LaneVector& blocks, std::size_t piece) {
  LaneVector net;
  const std::size_t start = piece / kLanes * block_size(shape) + piece % kLanes;
  for (std::size_t k = 0; k < static_cast<std::size_t>(shape.size()); ++k)
    net.push_back(blocks[start + k * kLanes]);
  return net;
}

LaneVector blocks_of(const NetShape& shape, const std::vector<LaneVector>& nets) {
  LaneVector blocks(nets.size() * static_cast<std::size_t>(shape.size()));
  for (std::size_t piece = 0; piece < nets.size(); ++piece)
    for (std::size_t k = 0; k < nets[piece].size(); ++k)
      blocks[piece / kLanes * block_size(shape) + k * kLanes + piece % kLanes] = nets[piece][k];
  return blocks;
}

LaneVector cell_of_sheet(const SheetShape& sheet, const LaneVector& values, int i, int j) {
  LaneVector net;
  for (int p = 0; p < sheet.net.planes; ++p)
    for (int k = 0; k < sheet.net.rows; ++k)
      for (int l = 0; l < sheet.net.columns; ++l) net.push_back(values[sheet.at(i, j, p, k, l)]);
  return net;
}

LaneVector one_piece(NetForm form, const NetShape& shape, const LaneVector& net, const Interval& u,
                     const Interval& v, SimdLevel level) {
  LaneVector out(net.size());
  subdivide_piece(form, shape, net, u, v, out, level);
  return out;
}

LaneVector grid_of(const NetShape& shape, const LaneVector& net, const MatrixStack& u,
                   const MatrixStack& v, SimdLevel level) {
  LaneVector sheet(SheetShape{shape, u.pieces(), v.pieces()}.size());
  subdivide_grid(shape, net, u, v, sheet, level);
  return sheet;
}

TEST(BulkSubdivision, QuarterOfSaddleHasHandComputedNet) {
  for (SimdLevel level : all_levels()) {
    const MatrixStack halves(1, kHalves, NetForm::Bezier, level);
    const LaneVector sheet = grid_of(kSaddleShape, kSaddle, halves, halves, level);
    const LaneVector upper{0.5, 0.5, 1, 1, 0.5, 1, 0.5, 1, 0.25, 0.5, 0.5, 1};
    EXPECT_EQ(cell_of_sheet({kSaddleShape, 2, 2}, sheet, 1, 1), upper) << level_name(level);
    EXPECT_EQ(one_piece(NetForm::Bezier, kSaddleShape, kSaddle, {0.5, 1}, {0.5, 1}, level), upper);
  }
}

TEST(BulkSubdivision, ReachesBeyondThePatchAndRunsBackwards) {
  const LaneVector beyond{1, 1, 3, 3, 2, -1, 2, -1, 2, -1, 6, -3};
  for (SimdLevel level : all_levels())
    EXPECT_EQ(one_piece(NetForm::Bezier, kSaddleShape, kSaddle, {1, 3}, {2, -1}, level), beyond);
}

TEST(BulkSubdivision, ParabolaFromCoefficientsIsKnownByHand) {
  // x^2 in the middle form over t in [1/2, 1]: x in [0, 1].
  const NetShape shape{1, 3, 1};
  for (SimdLevel level : all_levels()) {
    EXPECT_EQ(one_piece(NetForm::Monomial, shape, {0, 0, 1}, {0, 1}, {0.5, 1}, level),
              (LaneVector{0, 0, 1}));
    Ends ends;
    for (int k = 0; k < kLanes; ++k) ends.add({0, 1}, {0.5, 1});
    LaneVector out(block_size(shape));
    subdivide_pieces_by_pyramid(shape, LaneVector{0, 0, 1}, ends.spans(), out, level);
    EXPECT_EQ(net_of_block(shape, out, 5), (LaneVector{0, 0, 1}));
  }
}

// Degrees 1 to 25 in both directions, in an order that mixes squares and others.
class BulkProperty : public ::testing::TestWithParam<int> {
 protected:
  int n() const { return 1 + GetParam() % 25; }
  int m() const { return GetParam() < 25 ? n() : 1 + (GetParam() * 7) % 25; }
  NetShape shape() const { return {n() + 1, m() + 1, GetParam() % 2 == 0 ? 3 : 4}; }
};

TEST_P(BulkProperty, MatricesAreTheExactOnesWithinTheStatedError) {
  auto random = seeded(GetParam());
  for (NetForm form : {NetForm::Bezier, NetForm::Monomial})
    for (SimdLevel level : all_levels()) {
      const Interval piece = narrow_piece(random, pick(random, 1, 40));
      const std::array cuts{piece.from, piece.to};
      const MatrixStack stack(n(), cuts, form, level);
      for (int k = 0; k <= n(); ++k) {
        const std::vector<Rational> expected = exact_row(form, arguments(piece, n(), k));
        for (int i = 0; i <= n(); ++i) {
          const Rational& entry = expected[static_cast<std::size_t>(i)];
          const double size = form == NetForm::Bezier ? entry.convert_to<double>() : 1.0;
          EXPECT_LE(exact_gap(stack(0, k, i), entry), bulk_matrix_error(n(), form) * size + 1e-300);
        }
      }
    }
}

TEST_P(BulkProperty, PiecesAreTheExactOnesWithinTheStatedError) {
  auto random = seeded(GetParam());
  double slack = 0;
  for (NetForm form : {NetForm::Bezier, NetForm::Monomial})
    for (SimdLevel level : all_levels()) {
      const LaneVector net = random_net(random, shape());
      const Ends ends = random_ends(random, kLanes);
      LaneVector out(block_size(shape()));
      subdivide_pieces(form, shape(), net, ends.spans(), out, level);

      const int plane = pick(random, 0, shape().planes - 1);
      const std::size_t piece = static_cast<std::size_t>(pick(random, 0, kLanes - 1));
      const double bound = form == NetForm::Bezier
                               ? bulk_bezier_error(n(), m())
                               : bulk_monomial_error(n(), m()) * sum_of_plane(shape(), net, plane);
      const double gap = largest_gap(form, shape(), net, net_of_block(shape(), out, piece), plane,
                                     ends.u(piece), ends.v(piece));
      EXPECT_LE(gap, bound) << level_name(level);
      slack = std::max(slack, gap / bound);
    }
  RecordProperty("error_over_bound", std::to_string(slack));
}

TEST_P(BulkProperty, PyramidPiecesAreTheExactOnesWithinTheStatedError) {
  auto random = seeded(GetParam());
  double slack = 0;
  for (SimdLevel level : all_levels()) {
    const LaneVector net = random_net(random, shape());
    const Ends ends = random_ends(random, kLanes);
    LaneVector out(block_size(shape()));
    subdivide_pieces_by_pyramid(shape(), net, ends.spans(), out, level);

    const int plane = pick(random, 0, shape().planes - 1);
    const std::size_t piece = static_cast<std::size_t>(pick(random, 0, kLanes - 1));
    const Interval u = ends.u(piece), v = ends.v(piece);
    const double bound = bulk_pyramid_error(n(), m()) * sum_of_plane(shape(), net, plane) *
                         pyramid_growth(n(), u) * pyramid_growth(m(), v);
    const double gap = largest_gap(NetForm::Monomial, shape(), net,
                                   net_of_block(shape(), out, piece), plane, u, v);
    EXPECT_LE(gap, bound) << level_name(level);
    slack = std::max(slack, gap / bound);
  }
  RecordProperty("error_over_bound", std::to_string(slack));
}

TEST_P(BulkProperty, APieceIsTheSameOnEveryPathBitForBit) {
  auto random = seeded(GetParam());
  const std::array u_cuts{0.0, uniform(random, 0.1, 0.4), uniform(random, 0.5, 0.9), 1.0};
  const std::array v_cuts{0.1, uniform(random, 0.2, 0.9), 1.0};
  for (NetForm form : {NetForm::Bezier, NetForm::Monomial})
    for (SimdLevel level : all_levels()) {
      std::vector<LaneVector> nets;
      for (int k = 0; k < kLanes; ++k) nets.push_back(random_net(random, shape()));
      const LaneVector blocks = blocks_of(shape(), nets);
      const MatrixStack u(n(), u_cuts, form, level), v(m(), v_cuts, form, level);
      const std::size_t lane = static_cast<std::size_t>(pick(random, 0, kLanes - 1));
      const LaneVector expected = one_piece(form, shape(), nets[lane], {u_cuts[1], u_cuts[2]},
                                            {v_cuts[1], v_cuts[2]}, level);

      const LaneVector sheet = grid_of(shape(), nets[lane], u, v, level);
      EXPECT_EQ(cell_of_sheet({shape(), 3, 2}, sheet, 1, 1), expected) << level_name(level);

      Ends ends;
      for (int k = 0; k < kLanes; ++k) ends.add({u_cuts[1], u_cuts[2]}, {v_cuts[1], v_cuts[2]});
      LaneVector own(block_size(shape())), shared(own);
      subdivide_pieces(form, shape(), blocks, ends.spans(), own, level);
      subdivide_pieces(form, shape(), nets[lane], ends.spans(), shared, level);
      EXPECT_EQ(net_of_block(shape(), own, lane), expected) << level_name(level);
      EXPECT_EQ(net_of_block(shape(), shared, 3), expected) << level_name(level);

      LaneVector sheets(6 * blocks.size()), cell;
      subdivide_blocks(shape(), blocks, u, v, sheets, level);
      for (int p = 0; p < shape().planes; ++p)
        for (int k = 0; k <= n(); ++k)
          for (int l = 0; l <= m(); ++l) {
            const int row = (p * 3 + 1) * (n() + 1) + k, column = m() + 1 + l;
            cell.push_back(
                sheets[static_cast<std::size_t>(row * 2 * (m() + 1) + column) * kLanes + lane]);
          }
      EXPECT_EQ(cell, expected) << level_name(level);
    }
}

TEST_P(BulkProperty, FusedLevelsGiveTheSameBitsAndPlainIsWithinBothBounds) {
  auto random = seeded(GetParam());
  const LaneVector net = random_net(random, shape());
  const Ends ends = random_ends(random, 2 * kLanes);
  std::vector<LaneVector> by_matrices, by_pyramid;
  for (SimdLevel level : all_levels()) {
    LaneVector out(2 * block_size(shape()));
    subdivide_pieces(NetForm::Bezier, shape(), net, ends.spans(), out, level);
    by_matrices.push_back(out);
    subdivide_pieces_by_pyramid(shape(), net, ends.spans(), out, level);
    by_pyramid.push_back(out);
  }
  if (is_available(SimdLevel::Avx512)) {
    EXPECT_EQ(by_matrices[1], by_matrices[2]);
    EXPECT_EQ(by_pyramid[1], by_pyramid[2]);
  }
  for (std::size_t k = 0; k < by_matrices[0].size(); ++k)
    EXPECT_NEAR(by_matrices.front()[k], by_matrices.back()[k], 2 * bulk_bezier_error(n(), m()));
}

TEST_P(BulkProperty, NeighboursInAGridShareTheirBordersBitForBit) {
  auto random = seeded(GetParam());
  const LaneVector net = random_net(random, shape());
  const std::array u_cuts{0.0, uniform(random, 0.1, 0.9), 1.0};
  const std::array v_cuts{0.0, uniform(random, 0.1, 0.9), 1.0};
  const SheetShape sheet{shape(), 2, 2};
  for (NetForm form : {NetForm::Bezier, NetForm::Monomial})
    for (SimdLevel level : all_levels()) {
      const MatrixStack u(n(), u_cuts, form, level), v(m(), v_cuts, form, level);
      const LaneVector values = grid_of(shape(), net, u, v, level);
      for (int p = 0; p < shape().planes; ++p) {
        for (int l = 0; l <= m(); ++l)
          EXPECT_EQ(values[sheet.at(0, 1, p, n(), l)], values[sheet.at(1, 1, p, 0, l)]);
        for (int k = 0; k <= n(); ++k)
          EXPECT_EQ(values[sheet.at(1, 0, p, k, m())], values[sheet.at(1, 1, p, k, 0)]);
      }
    }
}

TEST_P(BulkProperty, NeighbouringPatchesStayJoinedBitForBit) {
  auto random = seeded(GetParam());
  const LaneVector left = random_net(random, shape());
  LaneVector right = random_net(random, shape());
  const std::size_t row = static_cast<std::size_t>(m() + 1);
  const std::size_t plane = row * static_cast<std::size_t>(n() + 1);
  for (std::size_t p = 0; p < static_cast<std::size_t>(shape().planes); ++p)
    std::copy_n(&left[p * plane + plane - row], row, &right[p * plane]);
  const std::array v_cuts{0.0, uniform(random, 0.1, 0.9), 1.0};
  const MatrixStack u(n(), kHalves), v(m(), v_cuts);

  const LaneVector left_cells = grid_of(shape(), left, u, v, best_simd_level());
  const LaneVector right_cells = grid_of(shape(), right, u, v, best_simd_level());

  const SheetShape sheet{shape(), 2, 2};
  for (int p = 0; p < shape().planes; ++p)
    for (int l = 0; l <= m(); ++l)
      EXPECT_EQ(left_cells[sheet.at(1, 1, p, n(), l)], right_cells[sheet.at(0, 1, p, 0, l)]);
}

TEST_P(BulkProperty, DyadicMatricesAreThoseOfTheirCutsAndKept) {
  const MatrixStack& kept = dyadic_matrices(n(), 2);
  const MatrixStack made(n(), std::array{0.0, 0.25, 0.5, 0.75, 1.0});

  EXPECT_TRUE(std::ranges::equal(kept.rows(), made.rows()));
  EXPECT_TRUE(std::ranges::equal(kept.columns(), made.columns()));
  EXPECT_EQ(&kept, &dyadic_matrices(n(), 2));
  EXPECT_NE(&kept, &dyadic_matrices(n(), 2, NetForm::Monomial));
}

TEST_P(BulkProperty, TheChosenPathKeepsTheToleranceWhereAnyDoes) {
  auto random = seeded(GetParam());
  const LaneVector net = random_net(random, shape());
  LaneVector coefficients(net.size());
  monomial_from_bezier(shape(), net.data(), coefficients.data());
  const NetSizes sizes = net_sizes(shape(), net, coefficients);
  const Ends ends = random_ends(random, kLanes);
  LaneVector bezier(block_size(shape())), pyramid(bezier);
  subdivide_pieces(NetForm::Bezier, shape(), net, ends.spans(), bezier);
  subdivide_pieces_by_pyramid(shape(), coefficients, ends.spans(), pyramid);
  for (std::size_t piece = 0; piece < kLanes; piece += 3) {
    const Interval u = ends.u(piece), v = ends.v(piece);
    const double tolerance = 1e-9;
    const PiecePath path = piece_path(n(), m(), sizes, u, v, tolerance);
    const LaneVector& out = path == PiecePath::BezierMatrices ? bezier : pyramid;
    const auto gap_of = [&](const LaneVector& blocks) {
      return largest_gap(NetForm::Bezier, shape(), net, net_of_block(shape(), blocks, piece), 0, u,
                         v);
    };
    EXPECT_LE(gap_of(out), tolerance);
    EXPECT_LE(gap_of(pyramid), piece_error(PiecePath::MonomialPyramid, n(), m(), sizes, u, v));
  }
}

TEST_P(BulkProperty, PiecesWithinAToleranceTakeTheFastestPathThatKeepsIt) {
  auto random = seeded(GetParam());
  const LaneVector net = random_net(random, shape());
  LaneVector coefficients(net.size());
  monomial_from_bezier(shape(), net.data(), coefficients.data());
  const BothForms forms{net, coefficients, net_sizes(shape(), net, coefficients)};
  const Ends ends = random_ends(random, 4 * kLanes);
  LaneVector bezier(4 * block_size(shape())), pyramid(bezier), chosen(bezier);
  subdivide_pieces(NetForm::Bezier, shape(), net, ends.spans(), bezier);
  subdivide_pieces_by_pyramid(shape(), coefficients, ends.spans(), pyramid);
  for (const double tolerance : {0.0, 1e-14, 1e-11, 1e-8, 1.0, 1e300}) {
    subdivide_pieces_within(tolerance, shape(), forms, ends.spans(), chosen);
    for (std::size_t block = 0; block < 4; ++block) {
      const auto same_as = [&](const LaneVector& other) {
        const auto from = static_cast<std::ptrdiff_t>(block * block_size(shape()));
        const auto to = from + static_cast<std::ptrdiff_t>(block_size(shape()));
        return std::equal(chosen.begin() + from, chosen.begin() + to, other.begin() + from);
      };
      double error = 0;
      for (std::size_t k = block * kLanes; k < (block + 1) * kLanes; ++k)
        error = std::max(error, piece_error(PiecePath::MonomialPyramid, n(), m(), forms.sizes,
                                            ends.u(k), ends.v(k)));
      EXPECT_TRUE(same_as(pyramid) || same_as(bezier));
      // The block's bound takes u from one piece and v from another, so it may be larger.
      EXPECT_TRUE(error <= tolerance || same_as(bezier));
      EXPECT_TRUE(tolerance < 1e300 || same_as(pyramid));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Degrees, BulkProperty, ::testing::Range(0, 50));

TEST(BulkSubdivision, ChoosesThePyramidForSmoothLowDegreesAndMatricesForHighOnes) {
  const NetSizes unit{1, 1, 1e-15};
  EXPECT_EQ(piece_path(3, 3, unit, {0.7, 0.8}, {0.2, 0.3}, 1e-12), PiecePath::MonomialPyramid);
  EXPECT_EQ(piece_path(3, 3, unit, {0.7, 0.8}, {0.2, 0.3}, 1e-15), PiecePath::BezierMatrices);
  EXPECT_EQ(piece_path(20, 20, unit, {0, 1}, {0, 1}, 1e-7), PiecePath::BezierMatrices);
}

TEST(BulkSubdivision, GrowthIsOneAwayFromTheMiddleAndThreeToTheNAcross) {
  EXPECT_EQ(pyramid_growth(5, {0.5, 0.75}), 1);
  EXPECT_EQ(pyramid_growth(5, {0.75, 0.875}), 1);
  EXPECT_EQ(pyramid_growth(2, {0.25, 0.5}), 1);      // 1/2 + 1/2
  EXPECT_EQ(pyramid_growth(2, {0.25, 0.75}), 2.25);  // 1/2 + 1
  EXPECT_EQ(pyramid_growth(5, {0, 1}), 243);
  EXPECT_EQ(bezier_growth(5, {0, 1}), 1);
  EXPECT_EQ(bezier_growth(2, {0, 2}), 9);
}

class BulkRefusal : public ::testing::Test {
 protected:
  MatrixStack halves{1, kHalves};
  LaneVector sheet = LaneVector(SheetShape{kSaddleShape, 2, 2}.size());
  LaneVector block = LaneVector(block_size(kSaddleShape));
  LaneVector lanes = LaneVector(kLanes, 0.5);
};

std::string message_of(const auto& work) {
  try {
    work();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "no InvalidInput";
}

TEST_F(BulkRefusal, NamesWhatDoesNotFit) {
  EXPECT_EQ(message_of([&] { subdivide_grid(kSaddleShape, lanes, halves, halves, sheet); }),
            "subdivide_grid: net must have 12 values, got 8");
  EXPECT_EQ(message_of([&] { subdivide_grid(kSaddleShape, kSaddle, halves, halves, lanes); }),
            "subdivide_grid: sheet must have 96 values, got 8");
  EXPECT_EQ(message_of([&] {
              subdivide_grid(kSaddleShape, kSaddle, MatrixStack(2, kHalves), halves, sheet);
            }),
            "subdivide_grid: the matrices of u must be of degree 1, got 2");
  EXPECT_EQ(message_of([&] {
              subdivide_grid(kSaddleShape, kSaddle, halves,
                             MatrixStack(1, kHalves, NetForm::Monomial), sheet);
            }),
            "subdivide_grid: the matrices of v are for another form than those of u");
  EXPECT_EQ(
      message_of([&] {
        subdivide_grid({27, 2, 3}, kSaddle, halves, halves, sheet);
      }),
      "subdivide_grid: a net must have 1..26 rows and columns and 1..4 planes, got 27 x 2, 3");
}

TEST_F(BulkRefusal, NamesWhatDoesNotFitWithinATolerance) {
  const PieceEnds ends{lanes, lanes, lanes, lanes};
  EXPECT_EQ(message_of([&] {
              subdivide_pieces_within(1, kSaddleShape, {kSaddle, lanes, {}}, ends, block);
            }),
            "subdivide_pieces_within: coefficients must have 12 values, got 8");
  EXPECT_EQ(message_of([&] {
              subdivide_pieces_within(1, kSaddleShape, {kSaddle, kSaddle, {}}, ends, lanes);
            }),
            "subdivide_pieces_within: out must have 96 values, got 8");
  EXPECT_EQ(
      message_of([&] {
        subdivide_pieces_within(std::nan(""), kSaddleShape, {kSaddle, kSaddle, {}}, ends, block);
      }),
      "subdivide_pieces_within: the tolerance must be 0 or above");
}

TEST_F(BulkRefusal, NamesTheEndThatIsNotFinite) {
  LaneVector bad = lanes;
  bad[6] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(
      message_of([&] {
        subdivide_pieces(NetForm::Bezier, kSaddleShape, kSaddle, {lanes, bad, lanes, lanes}, block);
      }),
      "subdivide_pieces: u_to must be finite, number 7 is not");
  const LaneVector three(3, 0.5);
  EXPECT_EQ(
      message_of([&] {
        subdivide_pieces_by_pyramid(kSaddleShape, kSaddle, {three, three, three, three}, block);
      }),
      "subdivide_pieces_by_pyramid: the number of pieces must be a multiple of 8, got 3");
}

TEST_F(BulkRefusal, CoversCutsLevelsAndDegrees) {
  EXPECT_THROW(MatrixStack(3, std::array{0.0, 0.5, 0.5}), InvalidInput);
  EXPECT_THROW(MatrixStack(3, std::array{0.0}), InvalidInput);
  EXPECT_THROW(MatrixStack(26, kHalves), InvalidInput);
  EXPECT_THROW(dyadic_matrices(3, kMaxDyadicLevel + 1), InvalidInput);
  EXPECT_THROW(dyadic_matrices(-1, 2), InvalidInput);
}

}  // namespace
}  // namespace blossom
