// SPDX-License-Identifier: LGPL-2.1-or-later
// Holes of meshes: which rings there are, and what fills them.

#include "core/meshes/mesh_holes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/base/errors.h"
#include "core/math/index.h"

namespace blossom {
namespace {

struct Soup {
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;
};

// Each side of a closed mesh is walked once either way.
bool is_closed_mesh(const Soup& mesh) {
  std::map<std::pair<int, int>, int> count;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++count[{t[k], t[(k + 1) % 3]}];
  return std::ranges::all_of(count, [&](const auto& side) {
    const auto back = count.find({side.first.second, side.first.first});
    return side.second == 1 && back != count.end() && back->second == 1;
  });
}

double volume_of(const Soup& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    sum += dot(mesh.points[index(a)], cross(mesh.points[index(b)], mesh.points[index(c)])) / 6;
  return sum;
}

// The middle of the wall of a tube between rings of points, without lids.
Soup tube(int around, double radius, double inner) {
  Soup mesh;
  const auto ring = [&](double r, double z) {
    for (int k = 0; k < around; ++k) {
      const double angle = 2 * std::numbers::pi * k / around;
      mesh.points.push_back({r * std::cos(angle), r * std::sin(angle), z});
    }
  };
  const auto wall = [&](int low, int high) {
    for (int k = 0; k < around; ++k) {
      const int next = (k + 1) % around;
      mesh.triangles.push_back({low + k, low + next, high + next});
      mesh.triangles.push_back({low + k, high + next, high + k});
    }
  };
  ring(radius, 0);
  ring(radius, 1);
  wall(0, around);
  if (inner > 0) {
    ring(inner, 0);
    ring(inner, 1);
    wall(3 * around, 2 * around);
  }
  return mesh;
}

Soup filled(Soup mesh, const MeshHoles& holes) {
  for (const MeshHole& hole : holes.holes)
    mesh.triangles.insert(mesh.triangles.end(), hole.triangles.begin(), hole.triangles.end());
  return mesh;
}

TEST(MeshHoles, OfATubeAreItsTwoEnds) {
  for (const int around : {3, 12, 700}) {
    const Soup mesh = tube(around, 1, 0);
    const MeshHoles holes = fill_mesh_holes(mesh.points, mesh.triangles);
    EXPECT_EQ(holes.holes.size(), 2u);
    EXPECT_EQ(holes.left_sides, 0u);
    const Soup whole = filled(mesh, holes);
    EXPECT_TRUE(is_closed_mesh(whole));
    EXPECT_NEAR(volume_of(whole), 0.5 * around * std::sin(2 * std::numbers::pi / around), 1e-12);
  }
}

TEST(MeshHoles, InOnePlaneAreFilledTogether) {
  const Soup mesh = tube(24, 2, 1);
  const MeshHoles holes = fill_mesh_holes(mesh.points, mesh.triangles);
  ASSERT_EQ(holes.holes.size(), 2u);
  EXPECT_EQ(holes.holes[0].rings.size(), 2u);
  const Soup whole = filled(mesh, holes);
  EXPECT_TRUE(is_closed_mesh(whole));
  EXPECT_NEAR(volume_of(whole), 3 * 12 * std::sin(std::numbers::pi / 12), 1e-12);
}

// A saddle-shaped end takes the triangulation that bends least.
TEST(MeshHoles, ThatAreBentAreFilledWithoutFolds) {
  for (const int around : {16, 400}) {
    Soup mesh = tube(around, 1, 0);
    for (int k = 0; k < around; ++k)
      mesh.points[index(around + k)][2] += 0.2 * std::cos(4 * std::numbers::pi * k / around);
    const MeshHoles holes = fill_mesh_holes(mesh.points, mesh.triangles);
    const Soup whole = filled(mesh, holes);
    EXPECT_TRUE(is_closed_mesh(whole)) << around;
    const auto& bent = holes.holes[0].flat ? holes.holes[1] : holes.holes[0];
    EXPECT_FALSE(bent.flat);
    for (const auto& [a, b, c] : bent.triangles) {
      const Vec3 p = whole.points[index(a)];
      const Vec3 n = cross(whole.points[index(b)] - p, whole.points[index(c)] - p);
      EXPECT_GT(n[2], 0) << around;
    }
  }
}

TEST(MeshHoles, OfOnlyOneTriangleAreIts) {
  const Soup one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const MeshHoles holes = fill_mesh_holes(one.points, one.triangles);
  ASSERT_EQ(holes.holes.size(), 1u);
  EXPECT_TRUE(is_closed_mesh(filled(one, holes)));
}

// Two tetrahedra without a side each, that touch at their top.
TEST(MeshHoles, ThatTouchAtAPointAreTwo) {
  const Soup two{{{0, 0, 0}, {1, 0, -1}, {1, 1, -1}, {0, 1, -1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
                 {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {0, 4, 5}, {0, 5, 6}, {0, 6, 4}}};
  const MeshHoles holes = fill_mesh_holes(two.points, two.triangles);
  EXPECT_EQ(holes.holes.size(), 2u);
  EXPECT_TRUE(is_closed_mesh(filled(two, holes)));
}

TEST(MeshHoles, BesideSidesOfThreeTrianglesAreLeft) {
  const Soup fin{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                 {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}};
  const MeshHoles holes = fill_mesh_holes(fin.points, fin.triangles);
  EXPECT_TRUE(holes.holes.empty());
  EXPECT_EQ(holes.left_sides, 6u);
}

TEST(MeshHoles, AreNoneOfAClosedMesh) {
  const Soup mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                  {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  EXPECT_TRUE(fill_mesh_holes(mesh.points, mesh.triangles).holes.empty());
  const std::vector<std::array<int, 3>> bad{{0, 1, 7}};
  EXPECT_THROW(fill_mesh_holes(mesh.points, bad), InvalidInput);
}

}  // namespace
}  // namespace blossom
