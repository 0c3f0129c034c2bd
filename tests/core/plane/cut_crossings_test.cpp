// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/plane/cut_crossings.h"

#include <gtest/gtest.h>

#include <cmath>

namespace blossom {
namespace {

constexpr double kReach = 1e-7;
constexpr double kLongest = 1e-2;

// y = x^2 - depth over [-1, 1], by x.
PlanarCurve parabola(double depth) {
  return planar_curve({2, {-1, 1}, {3, 3}, {{-1, 1 - depth}, {0, -1 - depth}, {1, 1 - depth}}});
}

// y = 0 by x.
PlanarCurve axis() { return planar_line({-1, 0}, {1, 0}, {-1, 1}); }

// Closed, of two cubics: from the parabola's bottom, round its middle above and back.
PlanarCurve drop(double depth) {
  return planar_curve(
      {3,
       {0, 1, 2},
       {4, 3, 4},
       {{0, -depth}, {0.5, -depth}, {1, 1}, {0, 1}, {-1, 1}, {-0.5, -depth}, {0, -depth}}});
}

CutCrossings found(const PlanarCurve& a, const PlanarCurve& b, double longest = kLongest) {
  return cut_crossings(a, b, kReach, longest);
}

TEST(CutCrossings, AreOneWhereCutsKeepTogether) {
  constexpr double kDepth = 1e-9;
  const auto nodes = found(parabola(kDepth), axis()).nodes;
  ASSERT_EQ(nodes.size(), 1u);
  ASSERT_EQ(nodes[0].a.size(), 1u);
  EXPECT_NEAR(nodes[0].a[0], 0, 1e-9);
  EXPECT_NEAR(nodes[0].b[0], 0, 1e-9);
  EXPECT_GE(nodes[0].uncertainty, std::sqrt(kDepth));  // where they cross
  EXPECT_LE(nodes[0].uncertainty, 1.2 * std::sqrt(kDepth));
}

TEST(CutCrossings, AreTwoWhereCutsPartOrKeepTogetherTooLong) {
  EXPECT_EQ(found(parabola(1e-6), axis()).nodes.size(), 2u);
  EXPECT_EQ(found(parabola(1e-9), axis(), 1e-5).nodes.size(), 2u);
}

TEST(CutCrossings, OverTheEndOfAClosedCutHaveBothItsEnds) {
  for (const bool swapped : {false, true}) {
    const auto nodes = swapped ? found(axis(), drop(1e-9)).nodes : found(drop(1e-9), axis()).nodes;
    ASSERT_EQ(nodes.size(), 1u);
    const auto& closed = swapped ? nodes[0].b : nodes[0].a;
    const auto& straight = swapped ? nodes[0].a : nodes[0].b;
    EXPECT_EQ(closed, (std::vector<double>{0, 2}));
    ASSERT_EQ(straight.size(), 1u);
    EXPECT_NEAR(straight[0], 0, 1e-9);
  }
}

// The same loop, from another place of the touch.
TEST(CutCrossings, HaveOnePlaceOnBothCutsWhereverAClosedOneBegins) {
  constexpr double kDepth = 1e-9;
  const double start = 0.9 * std::sqrt(kDepth);
  const PlanarCurve loop = planar_curve({2,
                                         {0, 1, 2, 3},
                                         {3, 2, 2, 3},
                                         {{start, start * start - kDepth},
                                          {0.5 * (start + 1), start - kDepth},
                                          {1, 1 - kDepth},
                                          {0, 3},
                                          {-1, 1 - kDepth},
                                          {0.5 * (start - 1), -start - kDepth},
                                          {start, start * start - kDepth}}});
  const auto nodes = found(loop, axis()).nodes;
  ASSERT_EQ(nodes.size(), 1u);
  EXPECT_EQ(nodes[0].a, (std::vector<double>{0, 3}));
  ASSERT_EQ(nodes[0].b.size(), 1u);
  EXPECT_LE(distance(point_at(axis(), nodes[0].b[0]), point_at(loop, 0)), kReach);
}

// As two curves do that leave a common corner side by side: by what they are off, they cross again.
TEST(CutCrossings, AreTheEndsOfCutsThatKeepTogetherFromThere) {
  constexpr double kDepth = 1e-9;
  const double start = -std::sqrt(kDepth) / 8;
  const PlanarCurve bent = planar_curve(
      {2,
       {0, 1},
       {3, 3},
       {{start, start * start - kDepth}, {0.5 * (start + 1), start - kDepth}, {1, 1 - kDepth}}});
  const PlanarCurve straight = planar_line({start, 0}, {1, 0}, {0, 1});
  for (const bool swapped : {false, true}) {
    const auto nodes = swapped ? found(straight, bent).nodes : found(bent, straight).nodes;
    ASSERT_EQ(nodes.size(), 1u);
    EXPECT_EQ(nodes[0].a, std::vector<double>{0});
    EXPECT_EQ(nodes[0].b, std::vector<double>{0});
    EXPECT_GE(nodes[0].uncertainty, std::sqrt(kDepth) - start);
  }
  const auto on_axis = found(axis(), bent).nodes;
  ASSERT_EQ(on_axis.size(), 1u);
  EXPECT_EQ(on_axis[0].b, std::vector<double>{0});
  ASSERT_EQ(on_axis[0].a.size(), 1u);
  EXPECT_LE(distance(point_at(axis(), on_axis[0].a[0]), point_at(bent, 0)), kReach);
}

TEST(CutCrossings, AreTwoAtTheEndsOfACutThatKeepsToTheOtherAllAlong) {
  const PlanarCurve rest = planar_line({0, 1e-9}, {1e-4, 2e-9}, {0, 1});
  for (const auto& nodes : {found(axis(), rest).nodes, found(rest, axis()).nodes}) {
    ASSERT_EQ(nodes.size(), 2u);
    for (const CutCrossing& node : nodes)
      EXPECT_NEAR(node.point[0], &node == &nodes[0] ? 0 : 1e-4, 1e-9);
  }
}

TEST(CutCrossings, AreNotTheEndsOfARunThatCutsShare) {
  const PlanarCurve left = planar_line({-1, 0}, {0.004, 0}, {0, 1});
  EXPECT_EQ(found(left, planar_line({0, 0}, {1, 0}, {0, 1})).nodes.size(), 2u);
}

TEST(CutCrossings, ThatCrossEachOtherHaveNoBlur) {
  const auto nodes = found(planar_line({-1, -1}, {1, 1}, {0, 1}), axis()).nodes;
  ASSERT_EQ(nodes.size(), 1u);
  EXPECT_EQ(nodes[0].uncertainty, 0);
}

TEST(OnTheWay, GoesOverTheEndOfAClosedCurveWhereThatIsShorter) {
  const PlanarCurve closed = drop(0);
  EXPECT_DOUBLE_EQ(on_the_way(closed, 0.25, 0.75, 0.5, kReach), 0.5);
  EXPECT_DOUBLE_EQ(on_the_way(closed, 0.75, 0.25, 0.25, kReach), 0.625);
  EXPECT_DOUBLE_EQ(on_the_way(closed, 0.1, 1.7, 0.5, kReach), 1.9);
  EXPECT_DOUBLE_EQ(on_the_way(closed, 1.7, 0.1, 0.25, kReach), 1.8);
  EXPECT_DOUBLE_EQ(on_the_way(axis(), -0.9, 0.9, 0.25, kReach), -0.45);
}

}  // namespace
}  // namespace blossom
