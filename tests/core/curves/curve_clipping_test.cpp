// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/curves/curve_clipping.h"

#include <gtest/gtest.h>

#include "tests/support/curves.h"
#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::bezier;
using testing::Random;
using testing::seeded;
using testing::uniform;

constexpr double kTolerance = 1e-7;

// Whole curves as directed cells.
struct Trees {
  CurveSpans a, b;
  int dimension;
  CurveTree tree_a{a, Vec3{}, dimension}, tree_b{b, Vec3{}, dimension};

  Trees(CurveSpans first, CurveSpans second, int of_dimension)
      : a(std::move(first)), b(std::move(second)), dimension(of_dimension) {
    tree_a.direct(0);
    tree_b.direct(0);
  }
  FatLines lines(double tolerance = kTolerance) const {
    return {{tree_a, tree_a[0], tree_b, tree_b[0]}, tolerance};
  }
};

// A curve along x of a random degree, its weights uneven or 1.
CurveSpans random_curve(Random& random, int dimension, bool rational) {
  const int n = testing::pick(random, 1, 9);
  RationalBezierCurve curve;
  for (int i = 0; i <= n; ++i) {
    const double w = rational ? uniform(random, 0.2, 3) : 1;
    const double z = dimension == 3 ? uniform(random, -0.5, 0.5) : 0;
    curve.points.push_back(
        {w * (i + uniform(random, -0.3, 0.3)), w * uniform(random, -2, 2), w * z, w});
  }
  return curve_spans(curve);
}

bool holds(const Interval& part, double t) { return part.from <= t && t <= part.to; }

TEST(CurveClipping, LineLeavesTheHullOfAParabolaByHand) {
  // Control values 1, -1, 1 along y: the hull is below 0 from 1/4 to 3/4.
  const Trees trees(bezier({{0, 1, 0}, {0.5, -1, 0}, {1, 1, 0}}), bezier({{-1, 0, 0}, {3, 0, 0}}),
                    2);
  const auto parts = trees.lines().parts();
  ASSERT_TRUE(parts);
  EXPECT_NEAR(parts->a.from, 0.25, 1e-7);
  EXPECT_NEAR(parts->a.to, 0.75, 1e-7);
}

TEST(CurveClipping, NeverCutsOffACommonPoint) {
  auto random = seeded(1);
  for (int trial = 0; trial < 4000; ++trial) {
    const int dimension = 2 + trial % 2;
    const CurveSpans a = random_curve(random, dimension, trial % 3 == 0);
    CurveSpans b = random_curve(random, dimension, trial % 5 == 0);
    const double s = trial % 7 == 0 ? 1 : uniform(random, 0, 1), t = uniform(random, 0, 1);
    const Vec3 shift = point_at(a, s) - point_at(b, t);
    for (Vec4& p : b.spans[0].curve.points)
      p += Vec4{shift[0] * p[3], shift[1] * p[3], shift[2] * p[3], 0};
    const Trees trees(a, b, dimension);
    const FatLines lines = trees.lines(1e-14);
    ASSERT_FALSE(lines.separated());
    const auto parts = lines.parts();
    ASSERT_TRUE(parts);
    EXPECT_TRUE(holds(parts->a, s));
    EXPECT_TRUE(holds(parts->b, t));
  }
}

TEST(CurveClipping, KeepsWhatIsWithinToleranceAndNothingBeyond) {
  const CurveSpans line = bezier({{0, 0, 0}, {1, 0, 0}});
  const auto parts_at = [&](double gap) {
    const Trees trees(line, bezier({{0.2, gap, 0}, {0.4, gap + 0.5, 0}, {0.6, gap, 0}}), 2);
    const FatLines lines = trees.lines();
    return lines.separated() ? std::nullopt : lines.parts();
  };
  EXPECT_TRUE(parts_at(0.99 * kTolerance));
  EXPECT_FALSE(parts_at(1.01 * kTolerance));
}

TEST(CurveClipping, StripsAreAsWideAsBothCells) {
  const Trees trees(bezier({{0, 0, 0}, {1, 0.25, 0}, {2, 0, 0}}),
                    bezier({{0, 0.5, 0}, {1, 0.5, 0}}), 2);
  EXPECT_TRUE(trees.lines(1).within_strip(0.5 + 1e-12));
  EXPECT_FALSE(trees.lines(1).within_strip(0.5 - 1e-12));
}

TEST(CurveClipping, PartsNearAPointHoldItsPlaceOnTheCurve) {
  auto random = seeded(2);
  for (int trial = 0; trial < 4000; ++trial) {
    const int dimension = 2 + trial % 2;
    const CurveSpans curve = random_curve(random, dimension, trial % 3 == 0);
    CurveTree tree(curve, Vec3{}, dimension);
    tree.direct(0);
    const double t = trial % 7 == 0 ? 0 : uniform(random, 0, 1);
    const auto part = part_near(tree, tree[0], point_at(curve, t), 1e-14);
    ASSERT_TRUE(part);
    EXPECT_TRUE(holds(*part, t));
  }
}

TEST(CurveClipping, PointsOutsideOfTheHullAreNotNear) {
  const CurveSpans curve = bezier({{0, 0, 0}, {1, 2, 0}, {2, -2, 0}, {3, 0, 0}});
  CurveTree tree(curve, Vec3{}, 2);
  tree.direct(0);
  EXPECT_FALSE(part_near(tree, tree[0], {0, 1e-6, 0}, kTolerance));
  EXPECT_TRUE(part_near(tree, tree[0], {0, 1e-8, 0}, kTolerance));
}

TEST(CurveCells, PartsLieOnTheirCurve) {
  auto random = seeded(3);
  for (int trial = 0; trial < 500; ++trial) {
    const CurveSpans curve = random_curve(random, 2, trial % 2 == 0);
    CurveTree tree(curve, Vec3{}, 2);
    const double from = trial % 3 == 0 ? -1e-13 : uniform(random, 0, 0.5);
    const double to = trial % 5 == 0 ? 1 + 1e-13 : uniform(random, 0.5, 1);
    const int part = tree.part(tree.part(0, {from, to}), {0.25, 0.75});
    const CurveCell& cell = tree[part];
    EXPECT_GE(cell.local.from, 0);
    EXPECT_LE(cell.local.to, 1);
    const Vec3 first{cell.hull[0], cell.hull[cell.points], 0};
    EXPECT_LE(distance(first, point_at(curve, cell.local.from)), 10 * cell.margin);
  }
}

TEST(CurveCells, SectorsHoldAllDirections) {
  auto random = seeded(4);
  int found = 0;
  for (int trial = 0; trial < 500; ++trial) {
    const CurveSpans curve = random_curve(random, 2, trial % 2 == 0);
    CurveTree tree(curve, Vec3{}, 2);
    const int part = tree.part(0, {0.3, 0.3 + uniform(random, 0.05, 0.6)});
    tree.direct(part);
    const CurveCell& cell = tree[part];
    if (!(cell.cosine > 0)) continue;
    ++found;
    for (int i = 0; i <= 20; ++i) {
      const Vec3 d = unit(tree.jet({0, at(cell.local, i / 20.0)}).first);
      EXPECT_GE(cross(cell.right, d)[2], -1e-13);
      EXPECT_GE(cross(d, cell.left)[2], -1e-13);
      EXPECT_GE(dot(cell.axis, d), cell.cosine - 1e-13);
    }
  }
  EXPECT_GE(found, 100);
}

TEST(CurveCells, SmallerCellsBoundTheBendMoreTightly) {
  // Bends by 12 t near t, 12 at the end.
  const CurveSpans curve = bezier({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 2, 0}});
  CurveTree tree(curve, Vec3{}, 2);
  EXPECT_NEAR(tree.bend_near({0, 0.01}, 1e-4), 12, 1e-6);
  tree.split_near({0, 0.01}, 1e-4);
  EXPECT_LE(tree.bend_near({0, 0.01}, 1e-4), 0.2);
  EXPECT_GE(tree.bend_near({0, 0.01}, 1e-4), 0.12);
}

}  // namespace
}  // namespace blossom
