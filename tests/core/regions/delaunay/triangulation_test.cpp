// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/regions/delaunay/triangulation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/base/errors.h"
#include "core/regions/delaunay/plane_predicates.h"

namespace blossom {
namespace {

std::vector<BorderSide> loop(int first, int count, bool clockwise = false) {
  std::vector<BorderSide> sides;
  for (int k = 0; k < count; ++k) {
    const int from = first + k, to = first + (k + 1) % count;
    sides.push_back(clockwise ? BorderSide{to, from} : BorderSide{from, to});
  }
  return sides;
}

std::vector<BorderSide> operator+(std::vector<BorderSide> a, const std::vector<BorderSide>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

double area(const std::vector<Vec2>& points, const Triangulation& made) {
  double sum = 0;
  for (const auto& [a, b, c] : made.triangles) {
    const auto at = [&](int i) { return points[static_cast<std::size_t>(i)]; };
    EXPECT_GT(orientation(at(a), at(b), at(c)), 0);
    const Vec2 u = at(b) - at(a), v = at(c) - at(a);
    sum += 0.5 * (u[0] * v[1] - u[1] * v[0]);
  }
  return sum;
}

const std::vector<Vec2> kSquare{{0, 0}, {4, 0}, {4, 4}, {0, 4}};

TEST(PlanePredicates, DecideWhatDoublesCannot) {
  const double e = 0x1p-52;
  EXPECT_EQ(orientation({0.5, 0.5}, {12, 12}, {24, 24}), 0);
  EXPECT_EQ(orientation({0.5 + e, 0.5}, {12, 12}, {24, 24}), -1);
  EXPECT_EQ(orientation({0.5, 0.5 + e}, {12, 12}, {24, 24}), 1);
  EXPECT_EQ(in_circle({0, 0}, {1, 0}, {1, 1}, {0, 1}), 0);
  EXPECT_EQ(in_circle({0, 0}, {1, 0}, {1, 1}, {0, 1 - e}), 1);
  EXPECT_EQ(in_circle({0, 0}, {1, 0}, {1, 1}, {0, 1 + e}), -1);
}

TEST(Triangulation, OfASquareIsTwoTriangles) {
  const Triangulation made = triangulate(kSquare, loop(0, 4));

  EXPECT_TRUE(made.consistent);
  EXPECT_EQ(made.triangles.size(), 2u);
  EXPECT_EQ(area(kSquare, made), 16);
}

TEST(Triangulation, LeavesHolesAndNotchesOut) {
  // A square with a notch and a hole, and an island in the hole.
  std::vector<Vec2> points{{0, 0}, {8, 0}, {8, 8}, {4, 3}, {0, 8}};
  for (const Vec2& p : {Vec2{1, 1}, Vec2{3, 1}, Vec2{3, 2.5}, Vec2{1, 2.5}}) points.push_back(p);
  for (const Vec2& p : {Vec2{1.5, 1.5}, Vec2{2, 1.5}, Vec2{2, 2}}) points.push_back(p);

  const Triangulation made = triangulate(points, loop(0, 5) + loop(5, 4, true) + loop(9, 3));

  EXPECT_TRUE(made.consistent);
  EXPECT_DOUBLE_EQ(area(points, made), 64 - 0.5 * 8 * 5 - 3 + 0.125);
}

TEST(Triangulation, TakesLoopsThatTouchAtAPointAndPointsOnOneLine) {
  // Two cells of a grid that meet at a corner only, and a hole that touches its border.
  const std::vector<Vec2> points{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 1}, {2, 2}, {1, 2}};
  const std::vector<BorderSide> cells{{0, 1}, {1, 2}, {2, 3}, {3, 0},
                                      {2, 4}, {4, 5}, {5, 6}, {6, 2}};

  const Triangulation made = triangulate(points, cells);

  EXPECT_TRUE(made.consistent);
  EXPECT_EQ(made.triangles.size(), 4u);
  EXPECT_EQ(area(points, made), 2);
}

TEST(Triangulation, FindsSidesThatCross) {
  const std::vector<BorderSide> bow{{0, 1}, {1, 3}, {3, 2}, {2, 0}};

  const Triangulation made = triangulate(kSquare, bow);

  EXPECT_EQ(made.conflicts, (std::vector<int>{1, 3}));
  EXPECT_TRUE(made.triangles.empty());
}

TEST(Triangulation, FindsASideThroughAPoint) {
  std::vector<Vec2> points = kSquare;
  points.insert(points.end(), {{2, 0}, {3, 1}, {1, 1}});  // the hole's tip lies on the lower side

  EXPECT_EQ(triangulate(points, loop(0, 4) + loop(4, 3, true)).conflicts, (std::vector<int>{0}));
}

TEST(Triangulation, TellsWhatEnclosesNothing) {
  EXPECT_FALSE(triangulate(kSquare, loop(0, 4, true)).consistent);
  std::vector<BorderSide> open = loop(0, 4);
  open.pop_back();
  EXPECT_FALSE(triangulate(kSquare, open).consistent);
}

TEST(Triangulation, RefusesWhatIsNoSide) {
  EXPECT_THROW(triangulate(kSquare, std::vector<BorderSide>{{0, 4}}), InvalidInput);
  EXPECT_THROW(triangulate(kSquare, std::vector<BorderSide>{{1, 1}}), InvalidInput);
  const std::vector<Vec2> equal{{0, 0}, {1, 0}, {1, 0}};
  EXPECT_THROW(triangulate(equal, loop(0, 3)), InvalidInput);
}

// A star with many random tips and a ring of grid points around: every triangle turns the right
// way, and the areas add up. The parameter is the seed.
class TriangulationProperty : public ::testing::TestWithParam<unsigned> {};

TEST_P(TriangulationProperty, AreasOfStarsAddUp) {
  std::mt19937 random(GetParam());
  const int count = 3 + static_cast<int>(random() % 60);
  std::uniform_real_distribution<double> radius(0.1, 1);
  std::vector<Vec2> points;
  double expected = 0;
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * std::numbers::pi * k / count, r = radius(random);
    points.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec2& a = points[k];
    const Vec2& b = points[(k + 1) % points.size()];
    expected += 0.5 * (a[0] * b[1] - a[1] * b[0]);
  }
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j) points.push_back({0.5 * i, 2 + 0.25 * j});
  const int grid = count;
  const std::vector<BorderSide> cell{
      {grid, grid + 20}, {grid + 20, grid + 24}, {grid + 24, grid + 4}, {grid + 4, grid}};

  const Triangulation made = triangulate(points, loop(0, count) + cell);

  ASSERT_TRUE(made.conflicts.empty());
  ASSERT_TRUE(made.consistent);
  EXPECT_EQ(made.triangles.size(), static_cast<std::size_t>(count));
  EXPECT_NEAR(area(points, made), expected + 2, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Seeds, TriangulationProperty, ::testing::Range(0u, 100u));

}  // namespace
}  // namespace blossom
