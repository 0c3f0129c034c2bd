// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/retry/near_origin.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

#include "core/surface_intersection.h"
#include "tests/support/quadric_patches.h"

namespace blossom {
namespace {

using testing::sphere_octant;

constexpr double kPoint = 1e-7;

BezierSurface octant_at(const Vec3& centre) {
  BezierSurface surface{{0, 1}, {0, 1}};
  surface.patches = Grid<RationalBezierPatch>(1, 1);
  surface.patches(0, 0) = sphere_octant(centre, 1);
  surface.rational = true;
  return surface;
}

TEST(NearOrigin, OnlyLargeCoordinatesOfOneSizeAreTaken) {
  const Box box{{1e6, -3e6, -1e6}, {1.5e6, -2e6, 1e6}};
  EXPECT_EQ(far_origin(box, kPoint), (Vec3{1.25e6, -2.5e6, 0}));
  EXPECT_EQ(far_origin(box, 1e-2), Vec3{});
  EXPECT_EQ(far_origin({{1, 1, 1}, {2, 2, 2}}, kPoint), Vec3{});
  EXPECT_EQ(far_origin({{1e6, 1e6, 1e6}, {3e6, 3e6, 3e6}}, kPoint), Vec3{});
}

TEST(NearOrigin, DifferencesAreAsGoodAsExact) {
  const Vec3 origin{1e6, 1e6, -1e6};
  const BezierSurface far = octant_at(origin);
  const BezierSurface near = seen_from(origin, far);
  for (std::size_t i = 0; i < far.patches(0, 0).points.values().size(); ++i) {
    const Vec4 &p = far.patches(0, 0).points.values()[i],
               &q = near.patches(0, 0).points.values()[i];
    EXPECT_EQ(p[3], q[3]);
    for (int k = 0; k < 3; ++k) {
      const long double exact =
          static_cast<long double>(p[k]) - static_cast<long double>(p[3]) * origin[k];
      EXPECT_LE(std::abs(static_cast<double>(q[k] - exact)), 1e-13);  // of the long double
    }
  }
}

TEST(NearOrigin, KnownCurvesAndResultsMoveAlong) {
  const Vec3 origin{1e6, 0, -1e6};
  IntersectionOptions options;
  options.known = {{{{1e6 + 1, 2, -1e6}}, 0, 0}};
  EXPECT_EQ(seen_from(origin, options).known.front().points.front(), (Vec3{1, 2, 0}));
  SurfaceIntersection found;
  found.points = {{{1, 2, 3}, {}, {}}};
  found.places = {{PlaceKind::Touch, {1, 2, 3}, {1, 2, 3}}};
  const SurfaceIntersection back = moved_back(origin, found);
  EXPECT_EQ(back.points.front().point, (Vec3{1e6 + 1, 2, -1e6 + 3}));
  EXPECT_LT(back.places.front().box_low[0], 1e6 + 1);
  EXPECT_GT(back.places.front().box_high[0], 1e6 + 1);
  EXPECT_NEAR(back.places.front().box_high[0], 1e6 + 1, 1e-8);
}

// The circle in which two balls cross, a quarter turn of it in all.
TEST(NearOrigin, CurvesAreThoseAtTheOrigin) {
  const auto crossing = [](const Vec3& at) {
    return intersect(octant_at(at), octant_at(at + Vec3{0.25, -0.5, -0.25}));
  };
  const SurfaceIntersection near = crossing({}), far = crossing({1e6, -1e6, 2e6});
  ASSERT_EQ(near.curves.size(), 1u);
  ASSERT_EQ(far.curves.size(), 1u);
  EXPECT_EQ(far.status, near.status);
  EXPECT_NEAR(far.curves.front().length, near.curves.front().length, 1e-8);
  const Vec3 start = far.curves.front().samples.front().point;
  EXPECT_NEAR(distance(start, Vec3{1e6, -1e6, 2e6}), 1, 1e-8);
  EXPECT_LT(far.curves.front().deviation.a, kPoint);
}

}  // namespace
}  // namespace blossom
