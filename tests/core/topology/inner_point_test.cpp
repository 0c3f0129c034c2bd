// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/topology/inner_point.h"

#include <gtest/gtest.h>

#include "tests/support/flat_trims.h"

namespace blossom::testing {
namespace {

FaceTrims polygon(const std::vector<Vec2>& corners) {
  FlatLoops loops;
  loops.add_polygon(corners);
  return trims_of(std::move(loops));
}

TEST(InnerPoint, IsInsideAndAwayFromWires) {
  for (const FaceTrims& trims :
       {square_without_disc(), half_disc(), polygon({{0, 0}, {4, 0}, {4, 4}, {3.9, 0.1}})}) {
    const auto point = inner_point(trims);
    ASSERT_TRUE(point.has_value());
    EXPECT_TRUE(is_inside(trims, *point));
    EXPECT_EQ(coedge_near(trims, {*point, *point}, 0.02, 40), nullptr);
  }
}

TEST(InnerPoint, IsFoundInSliversOfAnySlope) {
  for (const double width : {1e-3, 1e-6, 1e-9})
    for (const Vec2& far : {Vec2{4, 0}, Vec2{4, 3}, Vec2{0.001, 4}, Vec2{-4, 4}}) {
      const Vec2 aside = width / norm(far) * Vec2{-far[1], far[0]};
      const FaceTrims trims = polygon({{0, 0}, far, far + aside, aside});
      const auto point = inner_point(trims);
      ASSERT_TRUE(point.has_value()) << width;
      EXPECT_TRUE(is_inside(trims, *point)) << width;
    }
}

// Far from the origin neighbours among the numbers are farther apart than such a face is wide.
TEST(InnerPoint, IsNotLookedForBetweenNeighbouringNumbers) {
  for (const double at : {0.0, 1e6, 1e9})
    for (const double width : {1e-8, 1e-12, 0.0}) {
      FlatLoops loops;
      const int left = loops.add_vertex({at, at}), right = loops.add_vertex({at + 12, at + 5});
      const PlanarBezier below{{{at, at, 1}, {at + 6, at + 2.5, 1}, {at + 12, at + 5, 1}}};
      const PlanarBezier above{{{at + 12, at + 5, 1}, {at + 6, at + 2.5 + width, 1}, {at, at, 1}}};
      loops.loops.push_back({loops.coedge(PlanarCurve{{{below, {0, 1}}}}, left, right),
                             loops.coedge(PlanarCurve{{{above, {0, 1}}}}, right, left)});
      const FaceTrims trims = trims_of(std::move(loops));
      const auto point = inner_point(trims);
      EXPECT_TRUE(!point || is_inside(trims, *point));
    }
}

TEST(InnerPoint, IsNotOnBordersThatRunAlongTheLines) {
  FlatLoops loops;
  const int left = loops.add_vertex({0, 0}), right = loops.add_vertex({4, 0});
  loops.loops.push_back({loops.coedge(planar_line({0, 0}, {4, 0}, {0, 1}), left, right),
                         loops.coedge(planar_line({4, 0}, {0, 0}, {0, 1}), right, left)});
  EXPECT_FALSE(inner_point(trims_of(std::move(loops))).has_value());
}

// As where a cut ends in a vertex of a large tolerance.
TEST(InnerPoint, IsFoundWhereVerticesAloneCloseTheLoop) {
  for (const bool upright : {false, true}) {
    const auto turned = [&](double x, double y) { return upright ? Vec2{-y, x} : Vec2{x, y}; };
    FlatLoops loops;
    const int left = loops.add_vertex(turned(0, 0.005)), right = loops.add_vertex(turned(4, 0.005));
    loops.loops.push_back(
        {loops.coedge(planar_line(turned(0, 0), turned(4, 0), {0, 1}), left, right),
         loops.coedge(planar_line(turned(4, 0.01), turned(0, 0.01), {0, 1}), right, left)});
    const FaceTrims trims = trims_of(std::move(loops));
    const auto point = inner_point(trims);
    ASSERT_TRUE(point.has_value());
    EXPECT_TRUE(is_inside(trims, *point));
  }
}

TEST(InnerPoint, IsFoundBetweenManyHoles) {
  FlatLoops loops;
  loops.add_polygon(kSquare4);
  for (int i = 0; i < 8; ++i)
    for (int k = 0; k < 8; ++k) {
      const double x = 0.01 + 0.5 * i, y = 0.01 + 0.5 * k, size = 0.48;
      loops.add_polygon({{x, y}, {x, y + size}, {x + size, y + size}, {x + size, y}});
    }
  const FaceTrims trims = trims_of(std::move(loops));
  const auto point = inner_point(trims);
  ASSERT_TRUE(point.has_value());
  EXPECT_TRUE(is_inside(trims, *point));
}

}  // namespace
}  // namespace blossom::testing
