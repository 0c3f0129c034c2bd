// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/iso_line.h"

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace blossom {
namespace {

using testing::random_patch;
using testing::seeded;
using testing::uniform;

// The saddle z = x y over the unit square.
TEST(IsoLine, OfASaddleHasPointsAndDerivativesKnownByHand) {
  RationalBezierPatch saddle{Grid<Vec4>(2, 2)};
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) saddle.points(i, j) = {1.0 * i, 1.0 * j, 1.0 * i * j, 1};
  const PatchJet along_u = IsoLine(saddle, Along::U, 0.5).jet(0.25);
  EXPECT_EQ(along_u.point, (Vec3{0.25, 0.5, 0.125}));
  EXPECT_EQ(along_u.u, (Vec3{1, 0, 0.5}));
  EXPECT_EQ(along_u.v, (Vec3{0, 1, 0.25}));
  const PatchJet along_v = IsoLine(saddle, Along::V, 0.5).jet(0.25);
  EXPECT_EQ(along_v.point, (Vec3{0.5, 0.25, 0.125}));
  EXPECT_EQ(along_v.u, (Vec3{1, 0, 0.25}));
  EXPECT_EQ(along_v.v, (Vec3{0, 1, 0.5}));
}

// Degrees 0 to 7 by 1 to 5, weights in [1/2, 1), parameters a little outside as well.
TEST(IsoLine, HasTheJetsOfItsPatch) {
  auto random = seeded(7);
  for (int n = 0; n <= 7; ++n)
    for (int m = 1; m <= 5; ++m) {
      RationalBezierPatch patch = random_patch<Vec4>(random, n, m);
      for (Vec4& point : patch.points.values()) point[3] = uniform(random, 0.5, 1);
      const double u = uniform(random, -0.1, 1.1), v = uniform(random, -0.1, 1.1);
      const PatchJet whole = jet_at(patch, u, v, 1);
      for (const PatchJet& jet :
           {IsoLine(patch, Along::U, v).jet(u), IsoLine(patch, Along::V, u).jet(v)}) {
        EXPECT_LE(distance(jet.point, whole.point), 1e-12) << n << ' ' << m;
        EXPECT_LE(distance(jet.u, whole.u), 1e-11) << n << ' ' << m;
        EXPECT_LE(distance(jet.v, whole.v), 1e-11) << n << ' ' << m;
      }
    }
}

}  // namespace
}  // namespace blossom
