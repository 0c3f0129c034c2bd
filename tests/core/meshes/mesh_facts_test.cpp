// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/meshes/mesh_facts.h"

#include <gtest/gtest.h>

#include "core/base/errors.h"

namespace blossom {
namespace {

using Triangles = std::vector<std::array<int, 3>>;

const std::vector<Vec3> kCorners = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 3}};
const Triangles kTetrahedron = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

TEST(MeshFacts, OfATetrahedronAreItsAreaAndVolumeWhereverItIs) {
  const double slanted = 0.5 * norm(cross(Vec3{-2, 2, 0}, Vec3{-2, 0, 3}));
  for (const double far : {0.0, 1e6}) {
    std::vector<Vec3> points = kCorners;
    for (Vec3& p : points) p = p + Vec3{far, -far, far};
    const MeshFacts found = mesh_facts(points, kTetrahedron);
    EXPECT_TRUE(found.closed());
    EXPECT_EQ(found.parts, 1u);
    EXPECT_NEAR(found.volume, 2, 1e-12 * 2);
    EXPECT_NEAR(found.area, 2 + 3 + 3 + slanted, 1e-11);
    EXPECT_TRUE(faulty_sides(points.size(), kTetrahedron).empty());
  }
}

TEST(MeshFacts, NameTheSidesThatAreOpen) {
  const Triangles open(kTetrahedron.begin(), kTetrahedron.end() - 1);
  const MeshFacts found = mesh_facts(kCorners, open);
  EXPECT_FALSE(found.closed());
  EXPECT_EQ(found.volume, 0);
  const std::vector<FaultySide> expected = {
      {{0, 2}, true, false, false}, {{0, 3}, true, false, false}, {{2, 3}, true, false, false}};
  EXPECT_EQ(faulty_sides(kCorners.size(), open), expected);
}

TEST(MeshFacts, NameTheSidesThatAreTurnedOrCrowded) {
  const Triangles turned{{0, 1, 2}, {0, 1, 3}}, crowded{{0, 1, 2}, {1, 0, 3}, {0, 1, 3}};
  EXPECT_EQ(mesh_facts(kCorners, turned).turned_sides, 1u);
  EXPECT_EQ(faulty_sides(4, turned).front(), (FaultySide{{0, 1}, false, false, true}));
  EXPECT_EQ(mesh_facts(kCorners, crowded).crowded_sides, 1u);
  EXPECT_EQ(faulty_sides(4, crowded).front(), (FaultySide{{0, 1}, true, true, false}));
}

TEST(MeshFacts, StopWithinTheSortWhereTheyAreAskedTo) {
  Triangles many;  // fewer than what is done between two questions, but not than its sort does
  for (int k = 0; k < 30000; ++k) many.push_back(kTetrahedron[static_cast<std::size_t>(k % 4)]);
  struct Stop {};
  const auto stop = [] { throw Stop{}; };
  EXPECT_THROW(mesh_facts(kCorners, many, stop), Stop);
  EXPECT_THROW(faulty_sides(kCorners.size(), many, stop), Stop);
}

TEST(MeshFacts, RefuseCornersThatAreNotThere) {
  EXPECT_THROW(mesh_facts(kCorners, Triangles{{0, 1, 9}}), InvalidInput);
  EXPECT_THROW(mesh_facts(kCorners, Triangles{{0, 1, -1}}), InvalidInput);
}

}  // namespace
}  // namespace blossom
