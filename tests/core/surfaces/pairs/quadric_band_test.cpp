// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/pairs/quadric_band.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/forms/evaluation.h"
#include "tests/support/quadric_patches.h"
#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::cylinder_quarter;
using testing::seeded;
using testing::sphere_octant;
using testing::uniform;

constexpr double kTolerance = 1e-7;

CellTree tree_of(const RationalBezierPatch& patch) {
  return {patch, true, {0.1, 0.2, 0.3}, CellForm::Auto, 0.4865};
}

bool are_disjoint(const RationalBezierPatch& a, const RationalBezierPatch& b) {
  const CellTree tree_a = tree_of(a), tree_b = tree_of(b);
  const auto band = QuadricBand::of(tree_b, kTolerance);
  return band && band->misses(tree_a[0], tree_a.shape());
}

TEST(QuadricBand, KeepsSpheresAndCylindersOfOneAxisApartAtOnce) {
  for (const double gap : {1e-1, 1e-4, 1e-6}) {
    EXPECT_TRUE(are_disjoint(sphere_octant({}, 2 - gap), sphere_octant({}, 2)));
    EXPECT_TRUE(are_disjoint(sphere_octant({}, 2 + gap), sphere_octant({}, 2)));
    EXPECT_TRUE(are_disjoint(cylinder_quarter(2 + gap, 20), cylinder_quarter(2, 10)));
  }
}

TEST(QuadricBand, HoldsWhatIsWithinTolerance) {
  for (const double gap : {0.0, 1e-12, 0.99e-7, -0.99e-7}) {
    EXPECT_FALSE(are_disjoint(sphere_octant({}, 2 - gap), sphere_octant({}, 2)));
    EXPECT_FALSE(are_disjoint(cylinder_quarter(2 + gap, 20), cylinder_quarter(2, 10)));
  }
  EXPECT_FALSE(are_disjoint(sphere_octant({0.3, -0.3, 0}, 2), sphere_octant({}, 2)));  // they cross
}

TEST(QuadricBand, TellsPatchesOfOneQuadric) {
  const auto band = QuadricBand::of(tree_of(sphere_octant({1, 2, 3}, 2)), kTolerance);
  ASSERT_TRUE(band);
  RationalBezierPatch turned = sphere_octant({1, 2, 3}, 2);  // another part of the sphere
  for (Vec4& p : turned.points.values()) {
    const double x = p[0] - p[3];
    p[0] = p[3] - 0.6 * x - 0.8 * (p[1] - 2 * p[3]);
    p[1] = 2 * p[3] + 0.8 * x - 0.6 * (p[1] - 2 * p[3]);
  }
  EXPECT_TRUE(band->holds_tightly(tree_of(turned)));
  EXPECT_TRUE(band->holds_tightly(tree_of(sphere_octant({1, 2, 3 + 3e-8}, 2))));
  EXPECT_FALSE(band->holds_tightly(tree_of(sphere_octant({1, 2, 3}, 2 + 6e-8))));
  EXPECT_FALSE(band->holds_tightly(tree_of(cylinder_quarter(2, 1))));
}

// Cells of random patches: one that holds a point of the sphere is never said to miss it.
class CellsAtASphere : public ::testing::TestWithParam<int> {};

TEST_P(CellsAtASphere, AreNotMissedIfTheyHoldAPointOfIt) {
  auto random = seeded(GetParam());
  const RationalBezierPatch sphere = sphere_octant({}, 1);
  const auto band = QuadricBand::of(tree_of(sphere), kTolerance);
  ASSERT_TRUE(band);
  RationalBezierPatch patch{Grid<Vec4>(2 + GetParam() % 3, 2 + GetParam() / 3 % 3)};
  for (Vec4& p : patch.points.values()) {
    const double w = uniform(random, 0.3, 2);
    p = {w * uniform(random, 0, 1), w * uniform(random, 0, 1), w * uniform(random, 0, 1), w};
  }
  CellTree tree = tree_of(patch);
  int missed = 0, cells = 0;
  const auto visit = [&](const auto& self, int index) -> void {
    const Cell cell = tree[index];
    ++cells;
    double low = 1e300, high = -1e300;
    for (int i = 0; i <= 8; ++i)
      for (int j = 0; j <= 8; ++j) {
        const Vec3 x = point_at(patch, at(cell.u, i / 8.0), at(cell.v, j / 8.0));
        low = std::min(low, norm(x) - 1);
        high = std::max(high, norm(x) - 1);
      }
    if (band->misses(cell, tree.shape())) {
      ++missed;
      EXPECT_TRUE(low > kTolerance || high < -kTolerance);
      return;
    }
    if (cell.depth == 8) return;
    const int child = tree.split(index);
    self(self, child);
    self(self, child + 1);
  };
  visit(visit, 0);
  EXPECT_TRUE(missed > 0 || cells > 1);
}

INSTANTIATE_TEST_SUITE_P(Seeds, CellsAtASphere, ::testing::Range(0, 60));

}  // namespace
}  // namespace blossom
