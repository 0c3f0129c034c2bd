// SPDX-License-Identifier: LGPL-2.1-or-later
// Meshes whose holes are filled, and parts of meshes.

#include "plugin/meshes/mesh_fill.h"

#include <gtest/gtest.h>

#include "adapters/occt/base/errors.h"
#include "plugin/meshes/mesh_info.h"
#include "plugin/meshes/mesh_judge.h"
#include "plugin/meshes/mesh_parts.h"

namespace blossom::meshes {
namespace {

// A unit cube without the upper side.
FileMesh box() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
          {{0, 2, 1},
           {0, 3, 2},
           {0, 1, 5},
           {0, 5, 4},
           {1, 2, 6},
           {1, 6, 5},
           {2, 3, 7},
           {2, 7, 6},
           {3, 0, 4},
           {3, 4, 7}},
          {{"floor", 0}, {"walls", 2}}};
}

TEST(FilledMeshes, AreClosedAndTellTheirHoles) {
  const FilledMesh filled = with_holes_filled(box(), {});
  ASSERT_EQ(filled.holes.size(), 1u);
  EXPECT_EQ(filled.holes[0].sides, (std::vector<std::size_t>{4}));
  EXPECT_EQ(filled.holes[0].triangles, 2u);
  EXPECT_TRUE(filled.holes[0].flat);
  EXPECT_EQ(filled.mesh.groups, (std::vector<MeshGroup>{{"floor", 0}, {"walls", 2}, {"fill", 10}}));
  if (!filled.judged) GTEST_SKIP() << "without CGAL";
  EXPECT_TRUE(filled.judged->sound());
  EXPECT_DOUBLE_EQ(filled.judged->volume, 1);
}

// Only the turned triangle keeps it from being closed.
TEST(FilledMeshes, SayThatTurnedTrianglesAreNoHoles) {
  FileMesh mesh = with_holes_filled(box(), {}).mesh;
  std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
  const FilledMesh filled = with_holes_filled(mesh, {});
  EXPECT_TRUE(filled.holes.empty());
  if (!filled.judged) GTEST_SKIP() << "without CGAL";
  EXPECT_NE(mesh_fill_text("a.stl", filled)
                .find("3 sides whose triangles are turned against each other, which is no hole"),
            std::string::npos);
}

TEST(MeshInfo, HasBoxesWithTheDigitsOfTheirSize) {
  FileMesh mesh = box();
  for (Vec3& point : mesh.points) point = 10.0 * point + Vec3{1e7, 0, 0};
  EXPECT_NE(mesh_info_text("a.stl", mesh, facts_of(mesh), false)
                .find("box: [10000000, 0, 0] to [10000010, 10, 10]"),
            std::string::npos);
}

TEST(MeshInfo, SaysWhereNoTwoTrianglesHaveASideInCommon) {
  FileMesh mesh = box(), loose;
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    const int first = static_cast<int>(loose.points.size());
    for (const int corner : triangle)
      loose.points.push_back(mesh.points[static_cast<std::size_t>(corner)]);
    loose.triangles.push_back({first, first + 1, first + 2});
  }
  const auto says = [](const FileMesh& said, const char* told) {
    return mesh_info_text("a.obj", said, facts_of(said), false).find(told) != std::string::npos;
  };
  const char* const told = "no two triangles have a side in common";
  EXPECT_TRUE(says(loose, "points lie where others are"));
  EXPECT_FALSE(says(mesh, told));
  EXPECT_FALSE(says(mesh, "where others are"));
  for (std::size_t k = 0; k < loose.points.size(); ++k) loose.points[k][0] += 1e-3 * double(k);
  EXPECT_TRUE(says(loose, told));
}

TEST(FilledMeshes, CountPointsAtOnePlaceAsOne) {
  FileMesh mesh = box();
  mesh.points.push_back(mesh.points[4]);
  mesh.triangles[8][2] = 8;
  const FilledMesh filled = with_holes_filled(mesh, {});
  EXPECT_EQ(filled.holes.size(), 1u);
  EXPECT_EQ(filled.left_sides, 0u);
  EXPECT_EQ(filled.mesh.notes.size(), 1u);
}

TEST(MeshParts, AreGroupsByNumberAndName) {
  const FileMesh walls = chosen_groups(box(), {2}, {}, "a.ply");
  EXPECT_EQ(walls.triangles.size(), 8u);
  EXPECT_EQ(walls.groups, (std::vector<MeshGroup>{{"walls", 0}}));
  EXPECT_EQ(chosen_groups(box(), {}, {"floor"}, "a.ply").points.size(), 4u);
  EXPECT_THROW(chosen_groups(box(), {3}, {}, "a.ply"), occt::BadModel);
  EXPECT_THROW(chosen_groups(box(), {}, {"roof"}, "a.ply"), occt::BadModel);
}

TEST(MeshParts, AreNamedByTheirPartOrTheEndOfTheirName) {
  FileMesh mesh = box();
  mesh.groups = {{"House/Floor", 0}, {"House/Wall", 2}, {"Shed/Wall", 6}};
  const auto chosen = [&](const char* name) { return chosen_groups(mesh, {}, {name}, "a.ply"); };
  const auto refusal = [&](const char* name) -> std::string {
    try {
      chosen(name);
    } catch (const occt::BadModel& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(chosen("House").triangles.size(), 6u);
  EXPECT_EQ(chosen("Floor").groups, (std::vector<MeshGroup>{{"House/Floor", 0}}));
  EXPECT_EQ(refusal("Wall"), "a.ply: 'Wall' may be 'House/Wall' or 'Shed/Wall'");
  EXPECT_EQ(
      refusal("Roof"),
      "a.ply: there is no group 'Roof'; there are 'House/Floor', 'House/Wall' and 'Shed/Wall'");
}

}  // namespace
}  // namespace blossom::meshes
