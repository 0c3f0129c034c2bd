// SPDX-License-Identifier: GPL-3.0-or-later
#include "adapters/cgal/gpl/mesh_check.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "core/base/errors.h"

namespace blossom {
namespace {

using Triangles = std::vector<std::array<int, 3>>;

const std::vector<Vec3> kCorners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const Triangles kTetrahedron{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

TEST(MeshCheck, OfATetrahedronIsAllRight) {
  const cgal::MeshCheck check = cgal::check_mesh(kCorners, kTetrahedron);

  EXPECT_TRUE(check.manifold);
  EXPECT_TRUE(check.closed);
  EXPECT_EQ(check.self_intersections, 0);
  EXPECT_EQ(check.degenerate_triangles, 0);
  EXPECT_DOUBLE_EQ(check.volume, 1.0 / 6);
}

TEST(MeshCheck, OfAnInvertedTetrahedronHasNegativeVolume) {
  Triangles inverted = kTetrahedron;
  for (auto& [a, b, c] : inverted) std::swap(b, c);

  EXPECT_DOUBLE_EQ(cgal::check_mesh(kCorners, inverted).volume, -1.0 / 6);
}

TEST(MeshCheck, SeesAMissingTriangle) {
  const Triangles open(kTetrahedron.begin(), kTetrahedron.end() - 1);

  const cgal::MeshCheck check = cgal::check_mesh(kCorners, open);

  EXPECT_TRUE(check.manifold);
  EXPECT_FALSE(check.closed);
}

TEST(MeshCheck, SeesAnEdgeOfThreeTriangles) {
  std::vector<Vec3> points = kCorners;
  points.push_back({1, 1, 1});
  Triangles triangles = kTetrahedron;
  triangles.push_back({0, 1, 4});

  EXPECT_FALSE(cgal::check_mesh(points, triangles).manifold);
}

TEST(MeshCheck, SeesTrianglesThatDoNotAgreeOnTheOrientation) {
  Triangles triangles = kTetrahedron;
  std::swap(triangles[0][1], triangles[0][2]);

  EXPECT_FALSE(cgal::check_mesh(kCorners, triangles).manifold);
}

TEST(MeshCheck, CountsTrianglesThatPierceEachOther) {
  const std::vector<Vec3> points{{0, 0, 0},      {2, 0, 0},     {0, 2, 0},
                                 {0.5, 0.5, -1}, {0.5, 0.5, 1}, {3, 3, 0}};

  const cgal::MeshCheck check = cgal::check_mesh(points, Triangles{{0, 1, 2}, {3, 4, 5}});

  EXPECT_TRUE(check.manifold);
  EXPECT_EQ(check.self_intersections, 1);
  const auto pairs = cgal::crossing_triangles(points, Triangles{{0, 1, 2}, {3, 4, 5}});
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs.front()[0] + pairs.front()[1], 1);
}

TEST(MeshCheck, CountsTrianglesOfNoArea) {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};

  EXPECT_EQ(cgal::check_mesh(points, Triangles{{0, 1, 2}}).degenerate_triangles, 1);
}

TEST(MeshCheck, RefusesIndicesAndCoordinatesThatCannotBe) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Vec3> bad{{0, 0, 0}, {1, 0, nan}, {0, 1, 0}};
  EXPECT_THROW(cgal::check_mesh(kCorners, Triangles{{0, 1, 4}}), InvalidInput);
  EXPECT_THROW(cgal::check_mesh(kCorners, Triangles{{0, -1, 2}}), InvalidInput);
  EXPECT_THROW(cgal::check_mesh(kCorners, Triangles{{0, 1, 1}}), InvalidInput);
  EXPECT_THROW(cgal::check_mesh(bad, Triangles{{0, 1, 2}}), InvalidInput);
}

}  // namespace
}  // namespace blossom
