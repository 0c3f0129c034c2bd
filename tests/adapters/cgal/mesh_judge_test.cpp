// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/cgal/mesh_judge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "core/base/errors.h"

namespace blossom {
namespace {

using Triangles = std::vector<std::array<int, 3>>;

const std::vector<Vec3> kCorners{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 3}};
const Triangles kTetrahedron{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

TEST(MeshVerdict, OfATetrahedronIsClosedWithItsVolume) {
  const cgal::MeshVerdict found = cgal::judge_mesh(kCorners, kTetrahedron);
  EXPECT_TRUE(found.closed());
  EXPECT_DOUBLE_EQ(found.volume, 2);
  EXPECT_EQ(found.crossings, 0u);
  EXPECT_EQ(found.degenerate, 0u);
  EXPECT_EQ(found.parts, 1u);
}

TEST(MeshVerdict, CountsOpenTurnedAndCrowdedSides) {
  Triangles open = kTetrahedron;
  open.pop_back();
  EXPECT_EQ(cgal::judge_mesh(kCorners, open).open_sides, 3u);

  Triangles turned = kTetrahedron;
  std::swap(turned[0][0], turned[0][1]);
  const cgal::MeshVerdict found = cgal::judge_mesh(kCorners, turned);
  EXPECT_EQ(found.turned_sides, 3u);
  EXPECT_EQ(found.volume, 0);

  std::vector<Vec3> points = kCorners;
  points.push_back({-1, -1, 1});
  Triangles crowded = kTetrahedron;
  crowded.push_back({0, 3, 4});
  EXPECT_EQ(cgal::judge_mesh(points, crowded).crowded_sides, 1u);
}

// Half a turn about a side makes another tetrahedron there: it is gone along twice each way.
TEST(MeshVerdict, HasAVolumeWhereBodiesShareASide) {
  std::vector<Vec3> points = kCorners;
  points.push_back(-points[2]);
  points.push_back(-points[3]);
  Triangles both = kTetrahedron;
  const int moved[4] = {0, 1, 4, 5};
  for (const auto& [a, b, c] : kTetrahedron) both.push_back({moved[a], moved[b], moved[c]});
  const cgal::MeshVerdict one = cgal::judge_mesh(kCorners, kTetrahedron);

  const cgal::MeshVerdict found = cgal::judge_mesh(points, both);

  EXPECT_EQ(found.crowded_sides, 1u);
  EXPECT_EQ(found.open_sides + found.turned_sides, 0u);
  EXPECT_TRUE(found.closed());
  EXPECT_NEAR(found.volume, 2 * one.volume, 1e-14);
}

TEST(MeshVerdict, FindsCrossingsOfTrianglesThatShareNothingACornerOrASide) {
  const std::vector<Vec3> points{{0, 0, 0}, {4, 0, 0}, {0, 4, 0},  {1, 1, -1},
                                 {1, 1, 1}, {3, 3, 1}, {1, 1, -2}, {1, 1, 0}};
  EXPECT_EQ(cgal::judge_mesh(points, Triangles{{0, 1, 2}, {3, 4, 5}}).crossings, 1u);
  EXPECT_EQ(cgal::judge_mesh(points, Triangles{{0, 1, 2}, {0, 4, 6}}).crossings, 1u);
  // Folded onto the other one, and beside it.
  EXPECT_EQ(cgal::judge_mesh(points, Triangles{{0, 1, 2}, {1, 0, 7}}).crossings, 1u);
  EXPECT_EQ(cgal::judge_mesh(points, Triangles{{0, 1, 2}, {1, 0, 4}}).crossings, 0u);
  EXPECT_EQ(cgal::judge_mesh(points, Triangles{{0, 1, 2}, {0, 1, 2}}).crossings, 1u);
}

TEST(MeshVerdict, CountsTrianglesThatAreThereTwice) {
  Triangles twice = kTetrahedron;
  twice.push_back({kTetrahedron[0][1], kTetrahedron[0][0], kTetrahedron[0][2]});
  const cgal::MeshVerdict found = cgal::judge_mesh(kCorners, twice);
  EXPECT_EQ(found.crossings, 1u);
  EXPECT_EQ(found.repeated, 1u);
  EXPECT_EQ(cgal::judge_mesh(kCorners, kTetrahedron).repeated, 0u);
}

// As many pairs as the square of the triangles: memory must not grow with them.
TEST(MeshVerdict, CountsAllCrossingsOfCoincidentTrianglesAndListsTheFirst) {
  const int n = 60;
  const Triangles same(n, Triangles::value_type{0, 1, 2});
  std::set<std::array<int, 2>> told;

  const cgal::MeshVerdict found = cgal::judge_mesh(kCorners, same, {}, [&](int a, int b) {
    told.insert({a, b});
  });

  const std::size_t pairs = n * (n - 1) / 2;
  ASSERT_GT(pairs, cgal::kListedPairs);
  EXPECT_EQ(found.crossings, pairs);
  EXPECT_EQ(told.size(), pairs);
  ASSERT_EQ(found.crossing_pairs.size(), cgal::kListedPairs);
  EXPECT_TRUE(std::equal(found.crossing_pairs.begin(), found.crossing_pairs.end(), told.begin()));
}

TEST(MeshVerdict, CountsFlatTrianglesExactly) {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {0.1, 0.2, 0.3}, {0.5, 1.0, 1.5}};
  EXPECT_EQ(cgal::judge_mesh(points, Triangles{{0, 1, 2}, {0, 0, 1}}).degenerate, 2u);
  // 5 * 0.3 is not 1.5 in binary numbers.
  EXPECT_EQ(cgal::judge_mesh(points, Triangles{{0, 3, 4}}).degenerate, 0u);
}

TEST(MeshVerdict, RefusesWhatIsNoMesh) {
  EXPECT_THROW(cgal::judge_mesh(kCorners, Triangles{{0, 1, 9}}), InvalidInput);
  EXPECT_THROW(cgal::judge_mesh(std::vector<Vec3>{{std::nan(""), 0, 0}}, Triangles{}),
               InvalidInput);
}

}  // namespace
}  // namespace blossom
