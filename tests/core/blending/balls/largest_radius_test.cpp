// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/balls/largest_radius.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/errors.h"
#include "tests/support/ball_shapes.h"
#include "tests/support/surface_changes.h"

namespace blossom {
namespace {

using testing::plane_patch;

// A wall across a trough whose height is a function of x: the balls roll along the edge y = 0.
struct Trough {
  BezierSurface floor;
  BezierSurface wall = plane_patch({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {-3, 3}, {-1, 3});

  std::optional<LargestRadius> largest(double most = 0.6, double scale = 1) const {
    return largest_radius(whole_support(floor, 1), whole_support(wall, -1),
                          {Vec2{0.5, 0}, Vec2{0, 0}}, 0.01 * scale, most * scale);
  }
};

TEST(LargestRadius, OfATroughIsItsRadiusOfCurvature) {
  const auto found = Trough{testing::trough(2, 0.5, 1)}.largest();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->limit, RadiusLimit::Curvature);
  EXPECT_EQ(found->support, 0);
  EXPECT_NEAR(found->radius, 0.25, 1e-10);
  EXPECT_NEAR(found->charts[0][0], 0.5, 1e-7);
  EXPECT_LT(distance(found->centre, Vec3{0, 0.25, 0.25}), 1e-7);
}

// z = f(x) with curvature f'' / (1 + f'^2)^(3/2); its largest value by a fine search.
TEST(LargestRadius, OfACubicTroughIsItsLeastRadiusOfCurvature) {
  const auto f1 = [](double x) { return 4 * x + 1.5 * x * x; };
  const auto f2 = [](double x) { return 4 + 3 * x; };
  const auto radius = [&](double x) { return std::pow(1 + f1(x) * f1(x), 1.5) / f2(x); };
  Interval range{-0.4, 0.4};
  for (int i = 0; i < 100; ++i) {
    const double p = at(range, 0.382), q = at(range, 0.618);
    (radius(p) < radius(q) ? range.to = q : range.from = p);
  }
  const BezierSurface floor = testing::bicubic([](double s, double t) {
    const double x = s - 0.5;
    return Vec3{x, t, 2 * x * x + 0.5 * x * x * x};
  });
  const auto found = Trough{floor}.largest();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->limit, RadiusLimit::Curvature);
  EXPECT_NEAR(found->radius, radius(range.from), 1e-10);
  EXPECT_NEAR(found->charts[0][0] - 0.5, range.from, 1e-6);
}

// The plane z = 0 under a roof that is lowest in the middle of its ridge.
TEST(LargestRadius, BetweenFacingWallsIsHalfTheirDistance) {
  const BezierSurface floor = plane_patch({-1, -1, 0}, {2, 0, 0}, {0, 3, 0});
  const BezierSurface roof = testing::bicubic([](double s, double t) {
    const double x = s - 0.5;
    return Vec3{x, t, 4 * t * (1 - t) * (0.2 + 0.3 * x * x)};
  });
  const auto found = largest_radius(whole_support(floor, 1), whole_support(roof, -1),
                                    {Vec2{0.4, 1.0 / 3}, Vec2{0.3, 0}}, 0.005, 0.3);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->limit, RadiusLimit::Facing);
  EXPECT_NEAR(found->radius, 0.1, 1e-10);
  EXPECT_LT(distance(found->centre, Vec3{0, 0.5, 0.1}), 1e-7);
}

TEST(LargestRadius, IsWhereAContactReachesABorder) {
  const double angle = 1.1;
  const BezierSurface floor = plane_patch({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 3}, {0, 10});
  const BezierSurface wall =
      plane_patch({0, 0, 0}, {1, 0, 0}, {0, std::cos(angle), std::sin(angle)}, {0, 3}, {0, 10});
  // The floor's border comes nearest, 0.7, in its middle, the wall's 0.8 at the end x = 0.
  const std::vector<ContactBorder> borders{
      {0, [](const Vec2& p) { return 0.7 + (p[0] - 1.5) * (p[0] - 1.5) - p[1]; }},
      {1, [](const Vec2& p) { return 0.8 + 0.1 * p[0] - p[1]; }}};
  const auto find = [&](const std::vector<ContactBorder>& some) {
    return largest_radius(whole_support(floor, 1), whole_support(wall, -1),
                          {Vec2{1, 0}, Vec2{1, 0}}, 0.01, 2, some);
  };
  const auto first = find(borders), second = find({borders[1]}), none = find({});
  ASSERT_TRUE(first && second && none);
  EXPECT_EQ(first->limit, RadiusLimit::Border);
  EXPECT_EQ(first->border, 0);
  EXPECT_NEAR(first->radius, 0.7 * std::tan(angle / 2), 1e-10);
  EXPECT_NEAR(first->charts[0][0], 1.5, 1e-7);
  EXPECT_EQ(second->support, 1);
  EXPECT_NEAR(second->radius, 0.8 * std::tan(angle / 2), 1e-10);
  EXPECT_NEAR(second->charts[1][0], 0, 1e-12);
  EXPECT_EQ(none->limit, RadiusLimit::None);
  EXPECT_EQ(none->radius, 2);
}

TEST(LargestRadius, ScalesWithTheSurfaces) {
  auto random = testing::seeded(5);
  for (const double scale : {1e-3, 1e3}) {
    testing::Motion motion = testing::random_motion(random);
    motion.scale = scale;
    const Trough plain{testing::trough(2, 0.5, 1)};
    const Trough turned{testing::moved(plain.floor, motion), testing::moved(plain.wall, motion)};
    const auto found = turned.largest(0.6, scale);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->limit, RadiusLimit::Curvature);
    EXPECT_NEAR(found->radius / scale, 0.25, 1e-9);
  }
}

TEST(LargestRadius, RefusesWhatIsNoRange) {
  const Trough trough{testing::trough(2, 0.5, 1)};
  EXPECT_THROW(trough.largest(0.01), InvalidInput);
  EXPECT_THROW(trough.largest(-1), InvalidInput);
  EXPECT_THROW(largest_radius(whole_support(trough.floor, 1), whole_support(trough.wall, -1),
                              {Vec2{0.5, 0}, Vec2{0, 0}}, 0.01, 0.1, {ContactBorder{}}),
               InvalidInput);
}

}  // namespace
}  // namespace blossom
