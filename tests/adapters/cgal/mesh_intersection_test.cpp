// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/cgal/mesh_intersection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "core/base/errors.h"

namespace blossom {
namespace {

struct TestMesh {
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;
  cgal::MeshView view() const { return {points, triangles}; }
};

TestMesh cube(const Vec3& at, double size = 1) {
  TestMesh mesh;
  for (int k = 0; k < 8; ++k)
    mesh.points.push_back(at +
                          size * Vec3{k & 1 ? 1.0 : 0.0, k & 2 ? 1.0 : 0.0, k & 4 ? 1.0 : 0.0});
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

TestMesh octahedron() {
  return {{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}}};
}

// By circles of latitude; the poles are points.
TestMesh ball(const Vec3& centre, double radius, int n) {
  TestMesh mesh;
  mesh.points.push_back(centre + Vec3{0, 0, radius});
  for (int i = 1; i < n; ++i)
    for (int j = 0; j < 2 * n; ++j) {
      const double a = std::numbers::pi * i / n, b = std::numbers::pi * j / n;
      mesh.points.push_back(centre + radius * Vec3{std::sin(a) * std::cos(b),
                                                   std::sin(a) * std::sin(b), std::cos(a)});
    }
  mesh.points.push_back(centre - Vec3{0, 0, radius});
  const auto at = [&](int i, int j) { return 1 + (i - 1) * 2 * n + j % (2 * n); };
  const int south = static_cast<int>(mesh.points.size()) - 1;
  for (int j = 0; j < 2 * n; ++j) {
    mesh.triangles.push_back({0, at(1, j), at(1, j + 1)});
    mesh.triangles.push_back({south, at(n - 1, j + 1), at(n - 1, j)});
    for (int i = 1; i + 1 < n; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

double length_of(const cgal::MeshMeeting& found) {
  double length = 0;
  for (const cgal::MeshCurve& curve : found.curves) length += curve.length;
  return length;
}

bool all_closed(const cgal::MeshMeeting& found) {
  return std::ranges::all_of(found.curves, &cgal::MeshCurve::closed);
}

TEST(MeshMeeting, OfCubesIsOneClosedPolylineThoughTheirSidesMeet) {
  const cgal::MeshMeeting found =
      cgal::intersect_meshes(cube({0, 0, 0}).view(), cube({0.5, 0.5, 0.5}).view());
  ASSERT_EQ(found.curves.size(), 1u);
  EXPECT_TRUE(found.curves[0].closed);
  EXPECT_DOUBLE_EQ(found.curves[0].length, 3);
  EXPECT_EQ(found.curves[0].points.front(), found.curves[0].points.back());
  EXPECT_FALSE(found.touching);
  EXPECT_TRUE(found.points.empty());
  EXPECT_EQ(found.in_plane, 0u);
}

TEST(MeshMeeting, TellsWhatTouches) {
  const cgal::MeshMeeting beside =
      cgal::intersect_meshes(cube({0, 0, 0}).view(), cube({1, 0, 0}).view());
  EXPECT_TRUE(beside.touching);
  EXPECT_GT(beside.in_plane, 0u);
  EXPECT_TRUE(all_closed(beside));

  const cgal::MeshMeeting itself =
      cgal::intersect_meshes(cube({0, 0, 0}).view(), cube({0, 0, 0}).view());
  EXPECT_TRUE(itself.touching);

  const cgal::MeshMeeting at_corners =
      cgal::intersect_meshes(cube({0, 0, 0}).view(), cube({1, 1, 1}).view());
  EXPECT_FALSE(at_corners.touching);
  EXPECT_TRUE(at_corners.curves.empty());
  EXPECT_EQ(at_corners.points, std::vector<Vec3>({{1, 1, 1}}));
}

TEST(MeshMeeting, IsEmptyWhereOneIsInsideOrFar) {
  for (const TestMesh& other : {cube({0.25, 0.25, 0.25}, 0.5), cube({3, 0, 0})}) {
    const cgal::MeshMeeting found = cgal::intersect_meshes(cube({0, 0, 0}).view(), other.view());
    EXPECT_TRUE(found.curves.empty());
    EXPECT_TRUE(found.points.empty());
    EXPECT_FALSE(found.touching);
  }
}

TEST(MeshMeeting, OfBallsIsNearTheirCircleWhicheverIsFirst) {
  const TestMesh a = ball({0, 0, 0}, 1, 40), b = ball({0.7, 0.4, 0.3}, 0.9, 37);
  const cgal::MeshMeeting found = cgal::intersect_meshes(a.view(), b.view());
  ASSERT_EQ(found.curves.size(), 1u);
  EXPECT_TRUE(found.curves[0].closed);
  const double d = std::sqrt(0.74), x = (1 - 0.81 + d * d) / (2 * d);
  EXPECT_NEAR(found.curves[0].length, 2 * std::numbers::pi * std::sqrt(1 - x * x), 0.02);
  for (const Vec3& p : found.curves[0].points) EXPECT_NEAR(norm(p), 1, 0.005);
  EXPECT_NEAR(length_of(cgal::intersect_meshes(b.view(), a.view())), found.curves[0].length, 1e-12);
}

// Equal points that are several, as files have them where every triangle brings its own.
TEST(MeshMeeting, JoinsEqualPoints) {
  TestMesh loose;
  for (const auto& t : octahedron().triangles) {
    const int first = static_cast<int>(loose.points.size());
    for (const int corner : t) loose.points.push_back(octahedron().points[std::size_t(corner)]);
    loose.triangles.push_back({first, first + 1, first + 2});
  }
  const cgal::MeshMeeting found =
      cgal::intersect_meshes(loose.view(), cube({0.1, 0.2, 0.3}).view());
  ASSERT_EQ(found.curves.size(), 1u);
  EXPECT_TRUE(found.curves[0].closed);
}

// On a coarse grid corners lie on triangles, sides meet and triangles share their planes.
TEST(MeshMeeting, OfClosedMeshesIsClosedOnGridsToo) {
  std::mt19937 random(5);
  const auto tetrahedron = [&] {
    TestMesh mesh{{}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
    for (int k = 0; k < 4; ++k) {
      Vec3 p;
      for (double& x : p.coordinates) x = static_cast<double>(random() % 4);
      mesh.points.push_back(p);
    }
    return mesh;
  };
  int met = 0, touching = 0;
  for (int k = 0; k < 3000; ++k) {
    const TestMesh a = tetrahedron(), b = tetrahedron();
    const cgal::MeshMeeting found = cgal::intersect_meshes(a.view(), b.view());
    if (found.flat > 0) continue;
    EXPECT_TRUE(all_closed(found)) << "pair " << k;
    met += !found.curves.empty();
    touching += found.touching;
  }
  EXPECT_GT(met, 500);
  EXPECT_GT(touching, 100);
}

TEST(MeshSection, IsAClosedPolyline) {
  const cgal::MeshMeeting found =
      cgal::section_of_mesh(cube({0, 0, 0}).view(), {0, 0, 0.5}, {0, 0, 3});
  ASSERT_EQ(found.curves.size(), 1u);
  EXPECT_TRUE(found.curves[0].closed);
  EXPECT_DOUBLE_EQ(found.curves[0].length, 4);
  EXPECT_FALSE(found.touching);
}

TEST(MeshSection, GoesThroughCornersAndTellsWhatOnlyTouches) {
  const TestMesh mesh = octahedron();
  const cgal::MeshMeeting middle = cgal::section_of_mesh(mesh.view(), {0, 0, 0}, {0, 0, 1});
  ASSERT_EQ(middle.curves.size(), 1u);
  EXPECT_DOUBLE_EQ(middle.curves[0].length, 4 * std::sqrt(2.0));
  EXPECT_FALSE(middle.touching);
  const cgal::MeshMeeting top = cgal::section_of_mesh(mesh.view(), {0, 0, 1}, {0, 0, 1});
  EXPECT_TRUE(top.curves.empty());
  EXPECT_EQ(top.points, std::vector<Vec3>({{0, 0, 1}}));
  EXPECT_FALSE(top.touching);
  const cgal::MeshMeeting lid = cgal::section_of_mesh(cube({0, 0, 0}).view(), {0, 0, 1}, {0, 0, 1});
  EXPECT_TRUE(lid.touching);
  EXPECT_EQ(lid.in_plane, 2u);
}

TEST(MeshSection, OfAnOpenMeshIsOpen) {
  TestMesh mesh = cube({0, 0, 0});
  mesh.triangles.pop_back();
  const cgal::MeshMeeting found = cgal::section_of_mesh(mesh.view(), {0, 0, 0.25}, {0, 0, 1});
  ASSERT_EQ(found.curves.size(), 1u);
  EXPECT_FALSE(found.curves[0].closed);
}

TEST(MeshMeeting, RefusesBadInput) {
  TestMesh mesh = cube({0, 0, 0});
  EXPECT_THROW(cgal::section_of_mesh(mesh.view(), {0, 0, 0}, {0, 0, 0}), InvalidInput);
  EXPECT_THROW(cgal::section_of_mesh(mesh.view(), {0, 0, NAN}, {0, 0, 1}), InvalidInput);
  mesh.triangles[0][1] = 8;
  EXPECT_THROW(cgal::section_of_mesh(mesh.view(), {0, 0, 0}, {0, 0, 1}), InvalidInput);
  mesh = cube({0, 0, 0});
  mesh.points[3].coordinates[0] = INFINITY;
  EXPECT_THROW(cgal::intersect_meshes(mesh.view(), mesh.view()), InvalidInput);
}

}  // namespace
}  // namespace blossom
