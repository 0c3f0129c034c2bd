// SPDX-License-Identifier: LGPL-2.1-or-later
// How deep a patch gets behind a plane, cylinder or sphere that it touches along a parameter line.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/surfaces/pairs/elementary_side.h"

namespace blossom {
namespace {

constexpr Interval kAll{0, 1};
constexpr Interval kStart{0, 0};

// A quarter of a cylinder of radius r round the line x = 0, z = r, from (0, v, 0) upwards.
RationalBezierPatch quarter(double r) {
  const double w = std::numbers::sqrt2 / 2;
  RationalBezierPatch patch;
  patch.points = Grid<Vec4>(3, 2);
  for (int j = 0; j < 2; ++j) {
    patch.points(0, j) = {0, 1.0 * j, 0, 1};
    patch.points(1, j) = {r * w, w * j, 0, w};
    patch.points(2, j) = {r, 1.0 * j, r, 1};
  }
  return patch;
}

Elementary floor_at(double height) {
  return {ElementaryKind::Plane, {5, -3, height}, {0, 0, 1}, 0, 0, 0};
}

TEST(ElementarySide, OfACylinderOnATangentPlaneIsNoDeeperThanRounding) {
  const auto side = ElementarySide::of(floor_at(0), quarter(0.5));
  ASSERT_TRUE(side.has_value());
  EXPECT_LT(side->depth(0, kAll, kStart, kAll), 1e-13);
}

TEST(ElementarySide, TellsHowFarThePlaneIsIntoTheCylinder) {
  const auto side = ElementarySide::of(floor_at(1e-6), quarter(0.5));
  ASSERT_TRUE(side.has_value());
  const double depth = side->depth(0, kAll, kStart, kAll);
  EXPECT_GE(depth, 1e-6);
  EXPECT_LT(depth, 3e-6);
}

TEST(ElementarySide, SaysNothingOfAPlaneThatCrosses) {
  const Elementary wall{ElementaryKind::Plane, {0, 0, 0}, {1, 0, 0}, 0, 0, 0};
  const auto side = ElementarySide::of(wall, quarter(0.5));
  ASSERT_TRUE(side.has_value());
  EXPECT_GT(side->depth(0, kAll, kStart, kAll), 1e-2);
}

TEST(ElementarySide, SeesTheSideOfCylindersAndBalls) {
  const Elementary cylinder{ElementaryKind::Cylinder, {0, 0, -2}, {0, 1, 0}, 2, 0, 0};
  const Elementary around{ElementaryKind::Cylinder, {0, 0, 2}, {0, 1, 0}, 2, 0, 0};
  for (const Elementary& each : {cylinder, around}) {
    const auto side = ElementarySide::of(each, quarter(0.5));
    ASSERT_TRUE(side.has_value());
    EXPECT_LT(side->depth(0, kAll, kStart, kAll), 1e-12);
  }
  const Elementary ball{ElementaryKind::Sphere, {0, 0.5, -2}, {0, 0, 1}, 2, 0, 0};
  const auto side = ElementarySide::of(ball, quarter(0.5));
  ASSERT_TRUE(side.has_value());
  // It touches in a point of the line alone; beside it the cylinder's ruling is outside.
  EXPECT_GT(side->depth(0, kAll, kStart, kAll), 1e-3);
}

TEST(ElementarySide, SaysNothingWhereThePatchDoesNotBend) {
  RationalBezierPatch flat;
  flat.points = Grid<Vec4>(2, 2);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) flat.points(i, j) = {1.0 * i, 1.0 * j, 0, 1};
  const auto side = ElementarySide::of(floor_at(0), flat);
  ASSERT_TRUE(side.has_value());
  EXPECT_TRUE(std::isinf(side->depth(0, kAll, kStart, kAll)));
}

TEST(ElementarySide, IsNotToldOfConesAndTori) {
  const Elementary cone{ElementaryKind::Cone, {}, {0, 0, 1}, 0, 0, 0.5};
  const Elementary torus{ElementaryKind::Torus, {}, {0, 0, 1}, 3, 1, 0};
  EXPECT_FALSE(ElementarySide::of(cone, quarter(1)).has_value());
  EXPECT_FALSE(ElementarySide::of(torus, quarter(1)).has_value());
}

}  // namespace
}  // namespace blossom
