// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/meshes/polygon_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace blossom {
namespace {

std::vector<std::array<int, 3>> triangles_of_all(const std::vector<Vec3>& points) {
  std::vector<int> corners(points.size());
  std::iota(corners.begin(), corners.end(), 0);
  return polygon_triangles(points, corners);
}

// The areas of triangles, added without regard to how they are turned: more than the polygon's if
// they overlap.
double area_of_all(const std::vector<Vec3>& points) {
  double sum = 0;
  for (const auto& t : triangles_of_all(points)) {
    const auto p = [&](std::size_t k) { return points[static_cast<std::size_t>(t[k])]; };
    sum += 0.5 * norm(cross(p(1) - p(0), p(2) - p(0)));
  }
  return sum;
}

TEST(PolygonTriangles, OfAConvexOneAreAFanFromItsFirstCorner) {
  const std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  EXPECT_EQ(triangles_of_all(square), (std::vector<std::array<int, 3>>{{{0, 1, 2}}, {{0, 2, 3}}}));
}

TEST(PolygonTriangles, CoverAnLOnceWhereverItBegins) {
  std::vector<Vec3> l{{0, 0, 1}, {3, 0, 1}, {3, 1, 1}, {1, 1, 1}, {1, 3, 1}, {0, 3, 1}};
  for (int turn = 0; turn < 6; ++turn) {
    EXPECT_EQ(triangles_of_all(l).size(), 4u);
    EXPECT_DOUBLE_EQ(area_of_all(l), 5) << turn;
    std::rotate(l.begin(), l.begin() + 1, l.end());
  }
  std::reverse(l.begin(), l.end());  // seen from below
  for (const auto& t : triangles_of_all(l)) {
    const auto p = [&](std::size_t k) { return l[static_cast<std::size_t>(t[k])]; };
    EXPECT_LT(cross(p(1) - p(0), p(2) - p(0))[2], 0);
  }
}

TEST(PolygonTriangles, HaveAnAreaWherePointsLieOnSides) {
  const std::vector<Vec3> square{{0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {0, 2, 2}, {0, 0, 2}};
  for (const auto& t : triangles_of_all(square)) {
    const auto p = [&](std::size_t k) { return square[static_cast<std::size_t>(t[k])]; };
    EXPECT_GT(norm(cross(p(1) - p(0), p(2) - p(0))), 0);
  }
  EXPECT_DOUBLE_EQ(area_of_all(square), 4);
}

TEST(PolygonTriangles, OfOneThatCrossesItselfAreAsManyAsOfAnother) {
  EXPECT_EQ(triangles_of_all({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).size(), 2u);
  EXPECT_EQ(triangles_of_all({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}).size(), 2u);
}

TEST(PolygonTriangles, OfOneNearTheLargestNumberAreAsManyAsOfAnother) {
  const double x = 3e307;
  std::vector<Vec3> l{{0, 0, 1}, {x, 0, 1}, {x, 1, 1}, {1, 1, 1}, {1, 3, 1}, {0, 3, 1}};
  for (int turn = 0; turn < 6; ++turn) {
    EXPECT_EQ(triangles_of_all(l).size(), 4u) << turn;
    std::rotate(l.begin(), l.begin() + 1, l.end());
  }
}

}  // namespace
}  // namespace blossom
