// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangular patches through points and normals: what they interpolate and how smooth they join.

#include "core/meshes/smooth_triangles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/base/errors.h"
#include "core/math/index.h"

namespace blossom {
namespace {

struct Surface {
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;
};

// An octahedron whose triangles were divided into four so often, on the unit ball.
Surface ball(int levels) {
  Surface made{
      {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
      {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<int, int>, int> middles;
    std::vector<std::array<int, 3>> finer;
    const auto middle = [&](int a, int b) {
      const auto [at, is_new] = middles.try_emplace(std::pair<int, int>(std::minmax(a, b)),
                                                    static_cast<int>(made.points.size()));
      if (is_new) made.points.push_back(unit(made.points[index(a)] + made.points[index(b)]));
      return at->second;
    };
    for (const auto& [a, b, c] : made.triangles) {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    made.triangles = std::move(finer);
  }
  return made;
}

std::vector<CornerNormals> exact_normals(const Surface& ball) {
  std::vector<CornerNormals> normals;
  for (const auto& [a, b, c] : ball.triangles)
    normals.push_back({ball.points[index(a)], ball.points[index(b)], ball.points[index(c)]});
  return normals;
}

Vec3 at(const BezierTriangle& patch, double x, double y) {
  BezierTriangle step = patch;
  for (int degree = patch.degree; degree > 0; --degree) {
    BezierTriangle next{degree - 1, std::vector<Vec3>(BezierTriangle::count(degree - 1))};
    for (int nu = 0; nu < degree; ++nu)
      for (int mu = 0; nu + mu < degree; ++mu)
        next(nu, mu) = x * step(nu + 1, mu) + y * step(nu, mu + 1) + (1 - x - y) * step(nu, mu);
    step = next;
  }
  return step.points[0];
}

double largest_error(const SmoothMesh& mesh) {
  double most = 0;
  for (const BezierTriangle& patch : mesh.patches)
    for (double x = 0; x <= 1; x += 0.125)
      for (double y = 0; x + y <= 1; y += 0.125)
        most = std::max(most, std::abs(norm(at(patch, x, y)) - 1));
  return most;
}

TEST(SmoothMesh, GoesThroughPointsWithOneTangentPlaneAlongSides) {
  const Surface round = ball(1);
  const SmoothMesh smooth = smooth_mesh(round.points, round.triangles, exact_normals(round));
  ASSERT_EQ(smooth.patches.size(), 3 * round.triangles.size());
  EXPECT_EQ(smooth.smooth_sides, round.triangles.size() * 3 / 2);
  EXPECT_EQ(smooth.sharp_sides, 0u);
  EXPECT_LT(smooth.largest_angle, 1e-7);
  EXPECT_EQ(smooth.patches[0](4, 0), round.points[index(round.triangles[0][0])]);
  EXPECT_EQ(smooth.patches[0](0, 4), round.points[index(round.triangles[0][1])]);
}

TEST(SmoothMesh, GetsNearerToASphereByTheThirdPowerAtLeast) {
  const Surface coarse = ball(1), fine = ball(2);
  const double before =
      largest_error(smooth_mesh(coarse.points, coarse.triangles, exact_normals(coarse)));
  const double after = largest_error(smooth_mesh(fine.points, fine.triangles, exact_normals(fine)));
  EXPECT_LT(before, 0.02);
  EXPECT_LT(after, before / 8);
}

// The three patches of a triangle: control points beside a common side lie in one affine picture.
TEST(SmoothMesh, JoinsThePatchesOfATriangleWithOneDerivative) {
  const Surface round = ball(0);
  const SmoothMesh smooth = smooth_mesh(round.points, round.triangles, exact_normals(round));
  const BezierTriangle &a = smooth.patches[0], &b = smooth.patches[1];
  for (int k = 0; k < 4; ++k) {  // along the side from corner 1 to the middle
    const Vec3 here = a(0, 4 - k), next = a(0, 3 - k);
    EXPECT_EQ(here, b(4 - k, 0));
    const Vec3 centre = (1.0 / 3) * (here + a(1, 3 - k) + b(3 - k, 1));
    EXPECT_LT(norm(centre - next), 1e-15);
  }
}

TEST(SmoothMesh, KeepsPlanesAndCreases) {
  // Two squares at a right angle.
  const Surface bent{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}},
                     {{0, 1, 2}, {0, 2, 3}, {1, 0, 4}, {1, 4, 5}}};
  const auto normals = corner_normals(bent.points, bent.triangles, 0.7);
  EXPECT_LT(norm(normals[0][0] - Vec3{0, 0, 1}), 1e-15);
  EXPECT_LT(norm(normals[2][0] - Vec3{0, 1, 0}), 1e-15);
  const SmoothMesh smooth = smooth_mesh(bent.points, bent.triangles, normals);
  EXPECT_EQ(smooth.sharp_sides, 1u);
  EXPECT_EQ(smooth.smooth_sides, 2u);
  for (std::size_t k = 0; k < 6; ++k)
    for (const Vec3& p : smooth.patches[k].points) EXPECT_EQ(p[2], 0);
  // With a wider crease the edge is rounded.
  EXPECT_EQ(smooth_mesh(bent.points, bent.triangles, corner_normals(bent.points, bent.triangles, 2))
                .sharp_sides,
            0u);
}

struct Ended {};

// Three times it goes through all triangles.
TEST(SmoothMesh, LooksForNormalsUntilItIsEnded) {
  const Surface round = ball(0);
  for (int last = 1; last <= 3; ++last) {
    int asked = 0;
    const auto ask = [&] {
      if (++asked == last) throw Ended{};
    };
    EXPECT_THROW(corner_normals(round.points, round.triangles, 0.7, ask), Ended) << last;
  }
}

TEST(SmoothMesh, RefusesOtherNumbersOfNormals) {
  const Surface round = ball(0);
  EXPECT_THROW(smooth_mesh(round.points, round.triangles, {}), InvalidInput);
}

}  // namespace
}  // namespace blossom
