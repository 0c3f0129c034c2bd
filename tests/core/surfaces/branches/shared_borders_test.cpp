// SPDX-License-Identifier: LGPL-2.1-or-later
// Branches along the border of one surface, which the surfaces leave at small angles.

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "core/surface_intersection.h"
#include "tests/support/components.h"
#include "tests/support/cubic_family.h"
#include "tests/support/surface_changes.h"

namespace blossom {
namespace {

using testing::Components;
using testing::components;
using testing::Cubic;
using testing::cubic_pair;
using testing::CubicPair;
using testing::linear;

const Cubic kX = linear(0, 1, 0), kY = linear(0, 0, 1);

struct Ordered {
  const BezierSurface& a;
  const BezierSurface& b;
};

double length_of_all(const SurfaceIntersection& found) {
  return std::accumulate(found.curves.begin(), found.curves.end(), 0.0,
                         [](double sum, const auto& curve) { return sum + curve.length; });
}

// Above 1e-3 they are transversal curves, below it the surfaces stay together in ever wider strips.
TEST(SharedBorders, AreFoundAtSmallAngles) {
  const double length = intersect(cubic_pair(kX).a, cubic_pair(kX).b).curves.at(0).length;
  for (const double slope : {1.0, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
    SCOPED_TRACE(slope);
    const CubicPair pair = cubic_pair(slope * kX);
    // The search works on cells of the surface with more patches, so the split one takes the
    // border for that of the other surface.
    const BezierSurface split = testing::split_in_u(pair.b, 0.37);
    for (const Ordered& order : {Ordered{pair.a, pair.b}, {pair.b, pair.a}, {pair.a, split}}) {
      const SurfaceIntersection found = intersect(order.a, order.b);

      EXPECT_EQ(found.status, Status::Tolerance);
      EXPECT_EQ(components(found), (Components{.open = 1, .tangential = slope < 5e-4}));
      EXPECT_NEAR(length_of_all(found), length, 1e-6 * length);
    }
  }
}

// Where the strip is wide more may lie in it, here a second branch.
TEST(SharedBorders, KeepThePlacesBesideThem) {
  const CubicPair pair = cubic_pair(1e-3 * (kX * linear(-0.005, 1, 0)));
  const SurfaceIntersection found = intersect(pair.a, pair.b);
  EXPECT_EQ(components(found), (Components{.open = 1, .tangential = 1}));
  for (const double y : {0.1, 0.5, 0.9}) {
    const Vec3 branch = point_at(pair.a, Vec2{0.005, y});
    EXPECT_TRUE(std::ranges::any_of(found.places, [&](const Place& place) {
      for (int k = 0; k < 3; ++k)
        if (branch[k] < place.box_low[k] || branch[k] > place.box_high[k]) return false;
      return true;
    })) << y;
  }
}

// What the search found along them by itself is not there twice.
TEST(SharedBorders, ReplaceWhatIsFoundAlongThem) {
  const double length = intersect(cubic_pair(kX).a, cubic_pair(kX).b).curves.at(0).length;
  for (const Cubic& h : {1e-5 * (kX * kX), 1e-3 * (kX + -1e-9 * kY)}) {
    const CubicPair pair = cubic_pair(h);
    const SurfaceIntersection found = intersect(pair.a, testing::split_in_u(pair.b, 0.37));
    EXPECT_EQ(components(found), (Components{.open = 1, .tangential = 1}));
    EXPECT_NEAR(length_of_all(found), length, 1e-6 * length);
  }
}

// Branches that cross them within the strip end in its place.
TEST(SharedBorders, LeaveNoOpenEndsOfOthers) {
  for (const double scale : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
    SCOPED_TRACE(scale);
    for (const Cubic& h :
         {kX * linear(-0.5, 0, 1), kX * kY, kX * linear(-0.3, 0, 1) * linear(-0.6, 0, 1)}) {
      const CubicPair pair = cubic_pair(scale * h);
      EXPECT_EQ(intersect(pair.a, pair.b).status, Status::Tolerance);
      EXPECT_EQ(intersect(pair.a, testing::split_in_u(pair.b, 0.37)).status, Status::Tolerance);
    }
  }
}

}  // namespace
}  // namespace blossom
