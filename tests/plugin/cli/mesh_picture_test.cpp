// SPDX-License-Identifier: LGPL-2.1-or-later
// What pictures of triangles of a file show: places, outlines and faulty sides.

#include "plugin/pictures/results/meshes.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "plugin/pictures/scene/scene.h"

namespace blossom::cli {
namespace {

using namespace pictures;

using Sides = std::vector<std::array<int, 2>>;

meshes::FileMesh square() {
  meshes::FileMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

std::vector<PictureMesh> meshes_of(const meshes::FileMesh& mesh) {
  std::vector<PictureMesh> made;
  for (const PictureFaces& group : mesh_faces(mesh, "it", kFirstColour, 1, [] {}))
    made.insert(made.end(), group.meshes.begin(), group.meshes.end());
  return made;
}

TEST(MeshPicture, HasOnePlaceForEachNormalOfAPointAndOutlinesBordersAndCreases) {
  const PictureMesh flat = meshes_of(square()).at(0);
  EXPECT_EQ(flat.points, square().points);
  EXPECT_EQ(flat.triangles, square().triangles);
  EXPECT_EQ(flat.border, (Sides{{0, 1}, {0, 3}, {1, 2}, {2, 3}}));
  meshes::FileMesh bent = square();
  bent.points[3] = {0, 0, 1};
  const PictureMesh creased = meshes_of(bent).at(0);
  EXPECT_EQ(creased.points.size(), 6u);
  EXPECT_EQ(creased.normals.size(), 6u);
  EXPECT_EQ(creased.border.size(), 6u);
}

TEST(MeshPicture, OutlinesSidesBetweenGroups) {
  meshes::FileMesh mesh = square();
  mesh.groups = {{.name = "a", .first = 0}, {.name = "b", .first = 1}};
  const std::vector<PictureMesh> made = meshes_of(mesh);
  ASSERT_EQ(made.size(), 2u);
  EXPECT_EQ(made[1].points, (std::vector<Vec3>{{0, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
  for (const PictureMesh& one : made) EXPECT_EQ(one.border, (Sides{{0, 1}, {0, 2}, {1, 2}}));
}

TEST(MeshPicture, OutlinesNoSideOfARepeatedCorner) {
  meshes::FileMesh mesh = square();
  mesh.triangles.push_back({3, 3, 0});
  const std::vector<PictureMesh> made = meshes_of(mesh);
  EXPECT_FALSE(made.at(0).border.empty());
  for (const auto& [from, to] : made.at(0).border) EXPECT_NE(from, to);
}

TEST(MeshPicture, ShowsASideThatIsOpenAndCrowdedAsCrowdedOnly) {
  meshes::FileMesh mesh = square();
  mesh.points.push_back({0, 0, 1});
  mesh.triangles.push_back({2, 0, 4});
  const std::vector<PictureLayer> layers = faulty_side_layers(mesh, [] {});
  EXPECT_EQ(layers.at(0).items.size(), 6u);
  EXPECT_EQ(layers.at(1).items.size(), 1u);
  EXPECT_TRUE(layers.at(2).items.empty());
}

TEST(MeshPicture, IsDrawnFromTheMeshesThatItHoldsWithoutACopy) {
  Picture picture;
  picture.groups = mesh_faces(square(), "it", kFirstColour, 1, [] {});
  EXPECT_EQ(&scene_meshes(picture).at(0).mesh(), &picture.groups[0].meshes[0]);
}

}  // namespace
}  // namespace blossom::cli
