// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/distance/convex_pair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/cells/cell_tree.h"
#include "tests/support/shapes.h"
#include "tests/support/solids.h"

namespace blossom {
namespace {

using testing::random_point;
using testing::seeded;
using testing::uniform;

constexpr double kRounding = 1e-14;

// A bicubic dome z = height - bend (x^2 + y^2) / 2 over a square about the origin, nearly.
RationalBezierPatch dome(double size, double height, double bend, bool rational) {
  RationalBezierPatch patch{Grid<Vec4>(4, 4)};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const double x = size * (i / 3.0 - 0.5), y = size * (j / 3.0 - 0.5);
      const Vec3 p{x, y, height - 0.5 * bend * (x * x + y * y)};
      patch.points(i, j) = testing::weighted(p, rational ? 1 + 0.02 * i - 0.01 * j : 1.0);
    }
  return patch;
}

struct Whole {
  RationalBezierPatch patch;
  CellTree tree;

  Whole(const RationalBezierPatch& p, bool rational)
      : patch(p), tree(p, rational, Vec3{}, CellForm::Bezier, 0.5) {}
  CellOf cell() const { return {&tree[0], tree.shape(), {&patch, 2}}; }
};

double sampled_distance(const Whole& a, const Whole& b) {
  double least = 1e300;
  for (int i = 0; i < 12 * 12 * 12 * 12; ++i) {
    const auto t = [&](int k) { return i / static_cast<int>(std::pow(12, k)) % 12 / 11.0; };
    least = std::min(least, distance(point_at(a.patch, t(0), t(1)), point_at(b.patch, t(2), t(3))));
  }
  return least;
}

TEST(ConvexPair, BoundsTheDistanceOfTwoDomes) {
  for (const bool rational : {false, true}) {
    const Whole low(dome(0.4, 0, 1, rational), rational),
        high(dome(0.5, 3, -0.5, rational), rational);
    const double bound =
        convex_bound(low.cell(), high.cell(), {0.3, 0.4}, {0.6, 0.5}, 1e9, kRounding);
    const double sampled = sampled_distance(low, high);
    EXPECT_LE(bound, sampled);
    EXPECT_GE(bound, sampled - 1e-2);
  }
}

TEST(ConvexPair, KnowsThatADomeInsideABowlOfLessRadiusIsNotConvex) {
  // The upper one bends about a point below the lower one's foot: the distance there is greatest.
  const Whole low(dome(0.4, 0, 1, false), false), high(dome(0.5, 3, 0.5, false), false);
  EXPECT_EQ(convex_bound(low.cell(), high.cell(), {0.5, 0.5}, {0.5, 0.5}, 1e9, kRounding), 0);
}

// Bounds of domes that bend away from each other in pieces that are halved and halved again.
TEST(ConvexPair, BoundsTheDistanceOfPieces) {
  for (const bool rational : {false, true}) {
    Whole low(dome(0.4, 0, 1, rational), rational), high(dome(0.5, 3, -0.5, rational), rational);
    int piece = 0, other = 0;
    for (int depth = 0; depth < 24; ++depth) {
      piece = low.tree.split(piece) + depth % 2;
      other = high.tree.split(other) + depth % 3 % 2;
      const CellOf a{&low.tree[piece], low.tree.shape(), {&low.patch, 2}};
      const CellOf b{&high.tree[other], high.tree.shape(), {&high.patch, 2}};
      const Vec2 at_a{at(a.cell->u, 0.5), at(a.cell->v, 0.5)};
      const Vec2 at_b{at(b.cell->u, 0.5), at(b.cell->v, 0.5)};
      const double bound = convex_bound(a, b, at_a, at_b, 1e9, kRounding);
      double least = 1e300;
      for (int i = 0; i < 5 * 5 * 5 * 5; ++i) {
        const auto t = [&](int k) { return i / static_cast<int>(std::pow(5, k)) % 5 / 4.0; };
        least = std::min(least,
                         distance(point_at(low.patch, at(a.cell->u, t(0)), at(a.cell->v, t(1))),
                                  point_at(high.patch, at(b.cell->u, t(2)), at(b.cell->v, t(3)))));
      }
      // The corners are among the samples, and there the least distance of small pieces is.
      EXPECT_LE(bound, least + 4 * kRounding);
      EXPECT_GE(bound, least - std::ldexp(0.1, -depth)) << depth;
    }
  }
}

class ConvexPairProperty : public ::testing::TestWithParam<int> {};

TEST_P(ConvexPairProperty, IsAboveZeroForDomesAndNeverAboveTheDistanceOfSamples) {
  auto random = seeded(GetParam());
  const bool rational = GetParam() % 2 == 1;
  bool bends_away = true;
  const auto net = [&](double height) {
    const double bend = uniform(random, -0.5, 1);
    bends_away = bends_away && bend > 0.2;
    RationalBezierPatch patch = dome(0.5, height, bend * (height > 0 ? -1 : 1), rational);
    for (Vec4& p : patch.points.values()) {
      const Vec3 by = 0.001 * random_point(random);
      for (int k = 0; k < 3; ++k) p[k] += p[3] * by[k];
    }
    return patch;
  };
  const double height = uniform(random, 0.5, 3);
  const Whole a(net(0), rational), b(net(height), rational);
  const double bound = convex_bound(a.cell(), b.cell(), {0.5, 0.5}, {0.5, 0.5}, 1e9, kRounding);
  EXPECT_LE(bound, sampled_distance(a, b));
  if (bends_away && height > 2) {  // nearer ones turn too much for their gap
    EXPECT_GT(bound, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, ConvexPairProperty, ::testing::Range(0, 24));

}  // namespace
}  // namespace blossom
