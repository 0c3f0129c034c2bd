// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/retry/shorter_patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "tests/support/surface_changes.h"

namespace blossom {
namespace {

constexpr double kTolerance = 1e-7;

BezierSurface square(double size) {
  RationalBezierPatch patch{Grid<Vec4>(2, 2)};
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) patch.points(i, j) = {size * i, size * j, 0, 1};
  return testing::of_patch(patch);
}

SurfaceIntersection open_at(double u, double v) {
  Place place;
  place.parameters = {Interval{u, u}, Interval{v, v}, Interval{0, 1}, Interval{0, 1}};
  SurfaceIntersection found;
  found.places = {place};
  return found;
}

TEST(ShorterPatches, AreShortRoundAnOpenPlaceAndFewElsewhere) {
  const double most = longest_span(kTolerance), size = 1000;
  const auto cut = with_shorter_patches(square(size), OpenOn::First, open_at(0.2, 0.7), kTolerance);
  ASSERT_TRUE(cut);
  for (const auto& [knots, x] : {std::pair{cut->u_knots, 0.2}, std::pair{cut->v_knots, 0.7}}) {
    EXPECT_LE(knots.size(), 9u);
    const auto above = std::ranges::upper_bound(knots, x);
    EXPECT_LE((*above - *(above - 1)) * size, most * (1 + 1e-12));
  }
}

TEST(ShorterPatches, AreNotMadeOfShortOnesNorOfTooMany) {
  const double most = longest_span(kTolerance);
  const SurfaceIntersection found = open_at(0.2, 0.7);
  EXPECT_FALSE(with_shorter_patches(square(most), OpenOn::First, found, kTolerance));
  EXPECT_TRUE(with_shorter_patches(square(1.01 * most), OpenOn::First, found, kTolerance));
  // All of the second surface is open.
  EXPECT_TRUE(with_shorter_patches(square(30 * most), OpenOn::Second, found, kTolerance));
  EXPECT_FALSE(with_shorter_patches(square(300 * most), OpenOn::Second, found, kTolerance));
  EXPECT_FALSE(with_shorter_patches(square(10 * most), OpenOn::First, {}, kTolerance));
}

}  // namespace
}  // namespace blossom
