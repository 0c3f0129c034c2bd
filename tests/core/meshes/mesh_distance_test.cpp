// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/meshes/mesh_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "core/base/errors.h"
#include "tests/support/random.h"

namespace blossom {
namespace {

using Triangles = std::vector<std::array<int, 3>>;

const std::vector<Vec3> kSquare{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
const Triangles kTwo{{0, 1, 2}, {0, 2, 3}};

std::vector<Vec3> moved(std::vector<Vec3> points, const Vec3& by) {
  for (Vec3& p : points) p += by;
  return points;
}

TEST(FarthestPoint, OfAMovedSquareIsTheMove) {
  const auto found = farthest_point(kSquare, kTwo, moved(kSquare, {0, 0, 0.25}), kTwo, {1e-6});
  EXPECT_DOUBLE_EQ(found.lower, 0.25);
  EXPECT_DOUBLE_EQ(found.upper, 0.25);
}

TEST(FarthestPoint, OfAMeshFromItselfIsNone) {
  auto random = testing::seeded(6);
  constexpr int kSide = 12;
  std::vector<Vec3> points;
  Triangles triangles;
  for (int i = 0; i < kSide; ++i)
    for (int j = 0; j < kSide; ++j) {
      points.push_back({i + testing::uniform(random, 0, 0.3), j + testing::uniform(random, 0, 0.3),
                        testing::uniform(random, 0, 1)});
      if (i == 0 || j == 0) continue;
      const int here = i * kSide + j;
      triangles.push_back({here - kSide - 1, here - 1, here});
      triangles.push_back({here - kSide - 1, here, here - kSide});
    }
  const auto found = farthest_point(points, triangles, points, triangles, {1e-6});
  EXPECT_LE(found.upper, 1e-13);
}

TEST(FarthestPoint, IsFoundInsideOfAFacet) {
  // Two squares side by side; the middle of the gap between them is farthest.
  std::vector<Vec3> apart = kSquare;
  for (const Vec3& p : moved(kSquare, {2, 0, 0})) apart.push_back(p);
  const Triangles four{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  const std::vector<Vec3> whole{{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {0, 1, 0}};
  const auto found = farthest_point(whole, kTwo, apart, four, {1e-4});
  EXPECT_NEAR(found.lower, 0.5, 1e-4);
  EXPECT_LE(found.upper, 0.5 + 2e-4);
  EXPECT_GE(found.upper, 0.5);
  EXPECT_NEAR(found.point[0], 1.5, 1e-3);
  EXPECT_EQ(farthest_point(apart, four, whole, kTwo, {1e-4}).lower, 0);
}

TEST(FarthestPoint, IsBetweenItsBoundsForRandomMeshes) {
  auto random = testing::seeded(5);
  const auto drawn = [&] {
    std::vector<Vec3> points;
    for (int k = 0; k < 30; ++k)
      points.push_back({testing::uniform(random, 0, 1), testing::uniform(random, 0, 1),
                        testing::uniform(random, 0, 1)});
    return points;
  };
  Triangles triangles;
  for (int k = 0; k + 2 < 30; k += 3) triangles.push_back({k, k + 1, k + 2});
  for (int trial = 0; trial < 20; ++trial) {
    const std::vector<Vec3> a = drawn(), b = drawn();
    const auto fine = farthest_point(a, triangles, b, triangles, {1e-5});
    const auto coarse = farthest_point(a, triangles, b, triangles, {0.05});
    EXPECT_LE(fine.upper - fine.lower, 1.01e-5);
    EXPECT_LE(coarse.lower, fine.upper);
    EXPECT_LE(fine.lower, coarse.upper);
  }
}

struct Mesh {
  std::vector<Vec3> points;
  Triangles triangles;
};

// The paraboloid 2 z = x^2 + y^2 over the unit square, by squares of a side of 1 / n.
Mesh bowl(int n) {
  Mesh mesh;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const double x = 1.0 * i / n, y = 1.0 * j / n;
      mesh.points.push_back({x, y, 0.5 * (x * x + y * y)});
      if (i == 0 || j == 0) continue;
      const int here = i * (n + 1) + j;
      mesh.triangles.push_back({here - n - 2, here - 1, here});
      mesh.triangles.push_back({here - n - 2, here, here - n - 1});
    }
  return mesh;
}

// Facets are divided along the sides of the other mesh, not ever finer beside them.
TEST(FarthestPoint, OfTwoMeshesOfASurfaceTakesFewPieces) {
  const Mesh a = bowl(20), b = bowl(23);
  int asked = 0;  // once for 1024 pieces
  const auto found =
      farthest_point(a.points, a.triangles, b.points, b.triangles, {.accuracy = 1e-6}, [&] {
        ++asked;
        return true;
      });
  EXPECT_LE(found.upper - found.lower, 1.01e-6);
  EXPECT_GT(found.lower, 1e-5);
  EXPECT_LE(found.upper, 0.25 / 400 + 0.25 / 529);
  EXPECT_LE(asked, 12);
}

// Of no width but rounding, so that a plane may cross all three sides of a piece and more.
TEST(FarthestPoint, OfSliversIsBetweenItsBounds) {
  auto random = testing::seeded(8);
  const Mesh ground = bowl(12);
  for (int trial = 0; trial < 40; ++trial) {
    const Vec3 a{testing::uniform(random, 0, 1), testing::uniform(random, 0, 1), 0.3};
    const Vec3 b{testing::uniform(random, 0, 1), testing::uniform(random, 0, 1), 0.4};
    const std::vector<Vec3> sliver{a, b, a + testing::uniform(random, 0, 1) * (b - a)};
    const auto found = farthest_point(sliver, Triangles{{0, 1, 2}}, ground.points, ground.triangles,
                                      {.accuracy = 1e-9});
    EXPECT_LE(found.upper - found.lower, 1.01e-9);
    double sampled = 0;
    for (int k = 0; k <= 50; ++k) {
      const std::vector<Vec3> place(3, a + (k / 50.0) * (b - a));
      sampled = std::max(sampled, farthest_point(place, Triangles{{0, 1, 2}}, ground.points,
                                                 ground.triangles, {.accuracy = 1e-9})
                                      .lower);
    }
    EXPECT_LE(sampled, found.upper + 1e-12);
    EXPECT_LE(found.upper, sampled + 0.02 * distance(a, b));
  }
}

TEST(FarthestPoint, EndsWhereMoreWouldNotBeEnoughOrTooFar) {
  const Mesh a = bowl(20), b = bowl(23);
  const auto exact =
      farthest_point(a.points, a.triangles, b.points, b.triangles, {.accuracy = 1e-7});
  int asked = 0;
  const auto work = [&] {
    ++asked;
    return true;
  };
  const auto enough = farthest_point(a.points, a.triangles, b.points, b.triangles,
                                     {.accuracy = 1e-7, .enough = 1.5 * exact.upper}, work);
  EXPECT_LE(enough.upper, 1.5 * exact.upper);
  EXPECT_LE(enough.lower, exact.upper);
  const int of_enough = std::exchange(asked, 0);
  const auto far = farthest_point(a.points, a.triangles, b.points, b.triangles,
                                  {.accuracy = 1e-7, .too_far = 0.5 * exact.lower}, work);
  EXPECT_GT(far.lower, 0.5 * exact.lower);
  EXPECT_GE(far.upper, exact.lower);
  EXPECT_LE(asked, of_enough);
}

TEST(FarthestPoint, RefusesWhatIsNoMesh) {
  EXPECT_THROW(farthest_point(kSquare, kTwo, kSquare, Triangles{}, {1}), InvalidInput);
  EXPECT_THROW(farthest_point(kSquare, Triangles{{0, 1, 7}}, kSquare, kTwo, {1}), InvalidInput);
  EXPECT_THROW(farthest_point(kSquare, kTwo, kSquare, kTwo, {0}), InvalidInput);
}

}  // namespace
}  // namespace blossom
