// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/support/watertight_mesh.h"

#include <gtest/gtest.h>

#include <vector>

namespace blossom {
namespace {

using testing::Mesh;
using testing::WatertightSampler;

// Two unit squares, or a triangle over the first, above and below y = 0, with side 0 in common.
WatertightPieces two_pieces(bool triangle) {
  WatertightPieces pieces;
  pieces.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, -1, 0}, {1, -1, 0}};
  const auto side = [&](int from, int to) {
    const auto at = [&](int k) { return pieces.vertices[static_cast<std::size_t>(k)]; };
    pieces.sides.push_back({-1, from, to, {{at(from), at(to)}}});
  };
  for (const auto& [from, to] : std::vector<std::pair<int, int>>{
           {0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {4, 5}, {5, 1}, {2, 0}})
    side(from, to);
  const auto square = [&](double low) {
    BezierPatch patch{Grid<Vec3>(2, 2)};
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) patch.points(i, j) = {static_cast<double>(i), low + j, 0};
    return patch;
  };
  if (triangle)
    pieces.pieces.push_back({0,
                             BezierTriangle{1, {{1, 1, 0}, {1, 0, 0}, {0, 0, 0}}},
                             {0, 1, 2},
                             {0, 1, 7},
                             {true, true, true}});
  else
    pieces.pieces.push_back({0, square(0), {0, 1, 2, 3}, {0, 1, 2, 3}, {true, true, true, true}});
  pieces.pieces.push_back({0, square(-1), {4, 5, 1, 0}, {5, 6, 0, 4}, {true, true, false, true}});
  return pieces;
}

// The lower piece has more samples, so that the upper one has few along its other sides.
TEST(WatertightMesh, HidesNoSamplesBehindFacetsBetweenCoarseSides) {
  for (const bool triangle : {false, true})
    for (const int parts : {4, 16}) {
      const WatertightSampler sampler(two_pieces(triangle), {false}, {2, parts});
      const Mesh& mesh = sampler.mesh();
      double sum = 0;
      for (const auto& [a, b, c] : mesh.triangles) {
        const auto at = [&](int k) { return mesh.points[static_cast<std::size_t>(k)]; };
        const double area = 0.5 * cross(at(b) - at(a), at(c) - at(a))[2];
        EXPECT_GT(area, -1e-15);
        sum += area;
      }
      EXPECT_NEAR(sum, triangle ? 1.5 : 2, 1e-12);
    }
}

}  // namespace
}  // namespace blossom
