// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/regions/sliver_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <set>
#include <utility>

#include "core/regions/delaunay/plane_predicates.h"
#include "core/regions/delaunay/triangulation.h"
#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::seeded;
using testing::uniform;

using Corners = std::array<int, 3>;
using Sides = std::set<std::pair<int, int>>;

// A plane in space, u and v its directions; triangles at `borders` are to be `least` high.
TriangleChart plane(std::vector<Vec2> points, Sides borders, double least, Vec3 u = {1, 0, 0},
                    Vec3 v = {0, 1, 0}) {
  TriangleChart chart;
  chart.points = std::move(points);
  chart.jet = [u, v](const Vec2& at) { return PatchJet{at[0] * u + at[1] * v, u, v, {}, {}, {}}; };
  chart.least_height = [=](int from, int to) { return borders.contains({from, to}) ? least : 0; };
  chart.is_valid = [](const Corners&) { return true; };
  return chart;
}

const Vec2& point(const TriangleChart& chart, int vertex) {
  return chart.points[static_cast<std::size_t>(vertex)];
}

double height(const TriangleChart& chart, const Corners& t) {
  const auto in_space = [&](int vertex) { return chart.jet(point(chart, vertex)).point; };
  const Vec3 a = in_space(t[0]), b = in_space(t[1]), c = in_space(t[2]);
  return norm(cross(b - a, c - a)) / std::max({distance(a, b), distance(b, c), distance(c, a)});
}

double lowest(const TriangleChart& chart, const std::vector<Corners>& triangles) {
  double least = height(chart, triangles.front());
  for (const Corners& t : triangles) least = std::min(least, height(chart, t));
  return least;
}

double area(const TriangleChart& chart, const std::vector<Corners>& triangles) {
  double sum = 0;
  for (const auto& [a, b, c] : triangles) {
    const Vec2 ab = point(chart, b) - point(chart, a), ac = point(chart, c) - point(chart, a);
    sum += 0.5 * (ab[0] * ac[1] - ab[1] * ac[0]);
  }
  return sum;
}

// Sides without a triangle behind; none is used twice.
Sides borders_of(const std::vector<Corners>& triangles) {
  Sides sides;
  for (const Corners& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) EXPECT_TRUE(sides.insert({t[k], t[(k + 1) % 3]}).second);
  Sides result;
  for (const auto& [a, b] : sides)
    if (!sides.contains({b, a})) result.insert({a, b});
  return result;
}

TEST(LowTriangles, AreFlippedWhereThatRaisesThem) {
  TriangleChart chart = plane({{0, 0}, {1, -0.01}, {2, 0}, {1, 1}}, {{0, 1}, {1, 2}}, 0.1);
  std::vector<Corners> triangles{{0, 1, 2}, {0, 2, 3}};

  EXPECT_TRUE(raise_sliver_triangles(triangles, chart));

  EXPECT_EQ(triangles, (std::vector<Corners>{{0, 1, 3}, {1, 2, 3}}));
  EXPECT_EQ(chart.points.size(), 4u);
}

// A fan round the far end of a side that goes on nearly in line: any diagonal is as low.
TEST(LowTriangles, GetAVertexInsideWhereNoFlipHelps) {
  TriangleChart chart =
      plane({{0, 0}, {10, 0}, {10, 3}, {-3, 1}, {-2, 0.2}, {-1, 0.05}}, {{0, 1}, {5, 0}}, 0.1);
  std::vector<Corners> triangles{{0, 1, 5}, {5, 1, 4}, {4, 1, 3}, {3, 1, 2}};
  const Sides borders = borders_of(triangles);
  const double whole = area(chart, triangles);
  EXPECT_LT(lowest(chart, triangles), 0.05);

  EXPECT_TRUE(raise_sliver_triangles(triangles, chart));

  EXPECT_EQ(chart.points.size(), 7u);
  EXPECT_GT(lowest(chart, triangles), 0.3);
  EXPECT_NEAR(area(chart, triangles), whole, 1e-12);
  EXPECT_EQ(borders_of(triangles), borders);
}

// All corners but the first lie on one line through it in space, though not in the chart.
TEST(LowTriangles, AreRaisedAtAPole) {
  TriangleChart chart =
      plane({{1, 0}, {1, 1}, {0, 1}, {0, 0.6}, {0, 0.3}, {0, 0}}, {{2, 3}, {3, 4}, {4, 5}}, 0.01);
  chart.jet = [](const Vec2& at) {
    const double c = std::cos(at[0]), s = std::sin(at[0]), r = at[1];
    return PatchJet{{r * c, r * s, 0}, {-r * s, r * c, 0}, {c, s, 0}, {}, {}, {}};
  };
  std::vector<Corners> triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}};

  EXPECT_TRUE(raise_sliver_triangles(triangles, chart));

  for (const Corners& t : triangles) {
    const bool at_pole = std::ranges::count(t, 0) > 0 && std::ranges::count(t, 5) > 0;
    EXPECT_TRUE(at_pole || height(chart, t) > 0.01);
  }
}

TEST(LowTriangles, StayWhereTheRegionIsNarrow) {
  TriangleChart chart = plane({{0, 0}, {1, -0.01}, {2, 0}}, {{0, 1}, {1, 2}}, 0.1);
  std::vector<Corners> triangles{{0, 1, 2}};

  EXPECT_FALSE(raise_sliver_triangles(triangles, chart));

  EXPECT_EQ(triangles, (std::vector<Corners>{{0, 1, 2}}));
  EXPECT_EQ(chart.points.size(), 3u);
}

TEST(LowTriangles, StayWhereTheyAreHighEnough) {
  TriangleChart chart = plane({{0, 0}, {1, -0.01}, {2, 0}, {1, 1}}, {{0, 1}, {1, 2}}, 1e-3);
  std::vector<Corners> triangles{{0, 1, 2}, {0, 2, 3}};

  EXPECT_FALSE(raise_sliver_triangles(triangles, chart));
}

TEST(LowTriangles, StayWhereCurvedSidesLeaveNothingElse) {
  TriangleChart chart = plane({{0, 0}, {1, -0.01}, {2, 0}, {1, 1}}, {{0, 1}, {1, 2}}, 0.1);
  chart.is_valid = [](const Corners&) { return false; };
  std::vector<Corners> triangles{{0, 1, 2}, {0, 2, 3}};

  EXPECT_FALSE(raise_sliver_triangles(triangles, chart));
}

// Stars in a chart that is sheared in space, so that its Delaunay triangles are low there.
class LowTrianglesProperty : public ::testing::TestWithParam<int> {};

TEST_P(LowTrianglesProperty, CoverTheRegionOnceAndAreNoLower) {
  auto random = seeded(GetParam());
  std::vector<Vec2> points;
  std::vector<BorderSide> sides;
  Sides borders;
  const int count = 12 + GetParam();
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * std::numbers::pi * k / count, r = uniform(random, 0.7, 1);
    points.push_back({r * std::cos(angle), r * std::sin(angle)});
    sides.push_back({k, (k + 1) % count});
    borders.insert({k, (k + 1) % count});
  }
  TriangleChart chart =
      plane(points, borders, 1, {1, 0, 0}, {std::cos(0.1), std::sin(0.1), uniform(random, 0, 0.1)});
  std::vector<Corners> triangles = triangulate(points, sides).triangles;
  const double whole = area(chart, triangles), before = lowest(chart, triangles);

  raise_sliver_triangles(triangles, chart);

  for (const auto& [a, b, c] : triangles)
    EXPECT_GT(orientation(point(chart, a), point(chart, b), point(chart, c)), 0);
  EXPECT_NEAR(area(chart, triangles), whole, 1e-12);
  EXPECT_EQ(borders_of(triangles), borders);
  EXPECT_GE(lowest(chart, triangles), before);
}

INSTANTIATE_TEST_SUITE_P(Seeds, LowTrianglesProperty, ::testing::Range(0, 32));

}  // namespace
}  // namespace blossom
