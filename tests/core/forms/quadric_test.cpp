// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/quadric.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/forms/evaluation.h"
#include "tests/support/quadric_patches.h"
#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::cone_quarter;
using testing::cylinder_quarter;
using testing::seeded;
using testing::sphere_octant;
using testing::torus_quarter;
using testing::uniform;

TEST(Quadric, OfASphereIsItsEquation) {
  const auto q = quadric_of(sphere_octant({1, 2, 3}, 2));
  ASSERT_TRUE(q);
  // (|x - c|^2 - r^2) / (2 r), or its negative.
  const double sign = q->matrix[0][0] > 0 ? 1 : -1;
  const std::array<std::array<double, 4>, 4> expected{
      {{0.25, 0, 0, -0.25}, {0, 0.25, 0, -0.5}, {0, 0, 0.25, -0.75}, {-0.25, -0.5, -0.75, 2.5}}};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      EXPECT_NEAR(sign * q->matrix[i][j], expected[i][j], 1e-12) << i << ' ' << j;
}

TEST(Quadric, VanishesOnItsPatchAndGrowsLikeTheDistanceBesideIt) {
  auto random = seeded(1);
  for (const RationalBezierPatch& patch : {sphere_octant({1, 2, 3}, 2), cylinder_quarter(0.5, 40),
                                           cone_quarter(0.3, 1, 5), cylinder_quarter(1e3, 10)}) {
    const auto q = quadric_of(patch);
    ASSERT_TRUE(q);
    for (int trial = 0; trial < 20; ++trial) {
      const double u = uniform(random, -1, 2), v = uniform(random, -0.5, 1.5);
      const PatchJet at = jet_at(patch, u, v, 1);
      const double size = norm(at.point) + 1;
      EXPECT_NEAR(q->value({at.point[0], at.point[1], at.point[2], 1}), 0, 1e-11 * size * size);
    }
    const PatchJet middle = jet_at(patch, 0.5, 0.5, 1);
    EXPECT_NEAR(norm(q->gradient(middle.point)), 1, 1e-9);
    EXPECT_NEAR(std::abs(dot(q->gradient(middle.point), unit(cross(middle.u, middle.v)))), 1, 1e-9);
  }
}

TEST(Quadric, IsNotSeenInOtherPatches) {
  EXPECT_FALSE(quadric_of(torus_quarter(5, 2)));
  RationalBezierPatch plane = sphere_octant({}, 1);
  for (Vec4& p : plane.points.values()) p[2] = 0;
  EXPECT_FALSE(quadric_of(plane));
  RationalBezierPatch bumped = sphere_octant({}, 1);
  bumped.points(1, 1)[2] += 1e-6;
  EXPECT_FALSE(quadric_of(bumped));
  EXPECT_FALSE(quadric_of({Grid<Vec4>(4, 2)}));  // its degree alone tells
}

}  // namespace
}  // namespace blossom
