// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/pairs/regular_contact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "core/surface_intersection.h"
#include "tests/support/quadric_patches.h"
#include "tests/support/random.h"
#include "tests/support/surface_changes.h"

namespace blossom {
namespace {

using Heights = std::function<double(double, double)>;  // a polynomial of degree 2 in each

// Over the square [-1, 1]^2 turned by an angle: four patches that meet over (0, 0).
BezierSurface four_patches(const Heights& z, double turn) {
  BezierSurface surface;
  surface.u_knots = surface.v_knots = {-1, 0, 1};
  surface.patches = Grid<RationalBezierPatch>(2, 2);
  const double c = std::cos(turn), s = std::sin(turn);
  const auto value = [&](double u, double v) {
    const double x = c * u - s * v, y = s * u + c * v;
    return Vec4{x, y, z(x, y), 1};
  };
  // The middle control point of a parabola through three points.
  const auto middle = [](const Vec4& p, const Vec4& q, const Vec4& r) {
    return 2 * q - 0.5 * (p + r);
  };
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      Grid<Vec4> points(3, 3);
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) points(k, l) = value(i - 1 + 0.5 * k, j - 1 + 0.5 * l);
      for (int k = 0; k < 3; ++k) points(k, 1) = middle(points(k, 0), points(k, 1), points(k, 2));
      for (int l = 0; l < 3; ++l) points(1, l) = middle(points(0, l), points(1, l), points(2, l));
      surface.patches(i, j) = {points};
    }
  return surface;
}

// Round the z-axis, radii 1 and 0.4; its seam is the outer equator.
BezierSurface torus() {
  BezierSurface surface;
  surface.u_knots = surface.v_knots = {0, 1, 2, 3, 4};
  surface.rational = surface.closed_u = surface.closed_v = true;
  surface.patches = Grid<RationalBezierPatch>(4, 4);
  for (int j = 0; j < 4; ++j) {
    auto profile = testing::quarter_circle(0.4);
    for (Vec3& p : profile) {
      for (int k = 0; k < j; ++k) p = {-p[1], p[0], p[2]};
      p[0] += p[2];
    }
    RationalBezierPatch patch = testing::turned_quarter(profile);
    for (int i = 0; i < 4; ++i) {
      surface.patches(i, j) = patch;
      for (Vec4& p : patch.points.values()) p = {-p[1], p[0], p[2], p[3]};
    }
  }
  return surface;
}

// Surfaces that cross at a small angle in a point where four patches of each meet, along a curve
// that nearly follows a knot line of one of them, or lies anyhow.
TEST(RegularContact, ACurveThroughACommonCornerIsProven) {
  for (const double angle : {0.3, 0.03, 5e-3, 1e-3})
    for (int k = 0; k < 16; ++k) {
      const double off = k < 8 ? std::pow(10.0, -0.7 * k) : 0.37 * k;
      const double nx = -std::sin(off), ny = std::cos(off);
      const BezierSurface a = four_patches(
          [&](double x, double y) { return 0.1 * angle * (x * x - 0.7 * x * y + 0.3 * y * y); }, 0);
      const BezierSurface b = four_patches(
          [&](double x, double y) {
            return angle * (nx * x + ny * y) + 0.1 * angle * (0.2 * x * x + x * y - 0.5 * y * y);
          },
          k % 3 == 0 ? 0.0 : 0.6);
      const SurfaceIntersection found = intersect(a, b);

      EXPECT_EQ(found.status, Status::Complete) << angle << " " << k;
      EXPECT_TRUE(found.places.empty()) << angle << " " << k;
      ASSERT_EQ(found.curves.size(), 1) << angle << " " << k;
      for (const CurveEnd end : found.curves[0].ends)
        EXPECT_TRUE(end == CurveEnd::BorderA || end == CurveEnd::BorderB);
      EXPECT_GT(found.curves[0].length, 1.9);
    }
}

// So small an angle that the surfaces bend away from it nearby.
TEST(RegularContact, ABranchThatPassesACommonCornerIsNoCusp) {
  for (int k = 0; k < 8; ++k) {
    const double nx = -std::sin(0.37 * k), ny = std::cos(0.37 * k);
    const BezierSurface a = four_patches(
        [&](double x, double y) { return 0.05 * (x * x - 0.7 * x * y + 0.3 * y * y); }, 0);
    const BezierSurface b = four_patches(
        [&](double x, double y) {
          return 5e-4 * (nx * x + ny * y) + 0.05 * (0.2 * x * x + x * y - 0.5 * y * y);
        },
        k % 3 == 0 ? 0.0 : 0.6);
    for (const Place& place : intersect(a, b).places) EXPECT_NE(place.kind, PlaceKind::Cusp) << k;
  }
}

TEST(RegularContact, ContactsInACommonCornerStayPlaces) {
  const BezierSurface flat = four_patches([](double, double) { return 0.0; }, 0);
  const auto bump = four_patches([](double x, double y) { return x * x + 2 * y * y; }, 0.6);
  const auto saddle = four_patches([](double x, double y) { return x * x - 2 * y * y; }, 0.6);

  const SurfaceIntersection touch = intersect(flat, bump), node = intersect(flat, saddle);

  EXPECT_EQ(touch.status, Status::Tolerance);
  EXPECT_EQ(touch.points.size(), 1);
  EXPECT_EQ(touch.curves.size(), 0);
  EXPECT_EQ(node.status, Status::Tolerance);
  EXPECT_EQ(node.nodes.size(), 1);
  EXPECT_EQ(node.curves.size(), 4);
}

// At the border of a surface a curve may end on either side of a contact.
TEST(RegularContact, ACornerOfASurfaceIsNotInside) {
  BezierSurface quarter = four_patches([](double, double) { return 0.0; }, 0);
  quarter.u_knots = quarter.v_knots = {0, 1};
  const RationalBezierPatch upper = quarter.patches(1, 1);
  quarter.patches = Grid<RationalBezierPatch>(1, 1);
  quarter.patches(0, 0) = upper;
  const auto tilted = four_patches([](double x, double y) { return 0.01 * (x + y); }, 0);

  const SurfaceIntersection found = intersect(quarter, tilted);

  EXPECT_EQ(found.curves.size(), 0);
  EXPECT_TRUE(found.points.size() == 1 && found.places.size() == 1);
  EXPECT_EQ(found.status, Status::Tolerance);
}

// Control points that no plane holds exactly: rounding puts the curve on both sides by turns. Once
// the knot line y = 0 is a crease, too.
TEST(RegularContact, ACurveAlongAKnotLineIsProven) {
  for (int seed = 0; seed < 12; ++seed) {
    auto random = testing::seeded(seed);
    const testing::Motion motion = testing::random_motion(random);
    const double crease = seed % 3 == 0 ? 0.3 : 0;
    const auto base = [](double x, double y) { return 0.3 * x * x - 0.2 * x * y + 0.1 * y; };
    BezierSurface a =
        four_patches([&](double x, double y) { return base(x, y) + 0.4 * y * (1 + 0.2 * x); }, 0);
    for (int i = 0; i < 2; ++i)
      for (int k = 0; k < 3; ++k)
        for (int l = 1; l < 3; ++l) a.patches(i, 1).points(k, l)[2] += 0.5 * crease * l;
    const BezierSurface b = four_patches(base, 0.6);
    const auto [first, second] = seed % 2 == 0 ? std::pair{a, b} : std::pair{b, a};
    const SurfaceIntersection found =
        intersect(testing::moved(first, motion), testing::moved(second, motion));

    EXPECT_EQ(found.status, Status::Complete) << seed;
    EXPECT_TRUE(found.places.empty()) << seed;
    ASSERT_EQ(found.curves.size(), 1) << seed;
    EXPECT_NEAR(found.curves[0].samples.front().uv_a[0] + found.curves[0].samples.back().uv_a[0], 0,
                1e-6)
        << seed;
  }
}

// Along y = 0 the one surface ends: rounding decides whether they meet at all.
TEST(RegularContact, ACurveAlongAnOuterBorderStaysWithinTolerance) {
  auto random = testing::seeded(3);
  const testing::Motion motion = testing::random_motion(random);
  BezierSurface half =
      four_patches([](double x, double y) { return 0.1 * x * x + 0.4 * y * (1 + 0.2 * x); }, 0);
  half.v_knots = {0, 1};
  const Grid<RationalBezierPatch> all = half.patches;
  half.patches = Grid<RationalBezierPatch>(2, 1);
  for (int i = 0; i < 2; ++i) half.patches(i, 0) = all(i, 1);
  const BezierSurface b = four_patches([](double x, double) { return 0.1 * x * x; }, 0.6);

  EXPECT_EQ(intersect(testing::moved(half, motion), testing::moved(b, motion)).status,
            Status::Tolerance);
}

// Along y = 0 the surfaces cross but for one point, or they touch in a crease: nothing regular.
TEST(RegularContact, AKnotLineOfContactsIsNotProven) {
  auto random = testing::seeded(5);
  const testing::Motion motion = testing::random_motion(random);
  const BezierSurface node = four_patches([](double x, double y) { return y * (x - 0.3); }, 0);
  BezierSurface crease = four_patches([](double, double y) { return y; }, 0);
  for (int i = 0; i < 2; ++i)
    for (Vec4& p : crease.patches(i, 0).points.values()) p[2] = -p[2];
  const BezierSurface flat = four_patches([](double, double) { return 0.0; }, 0.6);

  for (const BezierSurface& a : {node, crease})
    EXPECT_NE(intersect(testing::moved(a, motion), testing::moved(flat, motion)).status,
              Status::Complete);
}

// The plane through both circles of a torus in which its patches join, one of them its seam.
TEST(RegularContact, ACurveAlongASeamIsProven) {
  auto random = testing::seeded(7);
  const testing::Motion motion = testing::random_motion(random);
  BezierSurface plane = four_patches([](double, double) { return 0.0; }, 0.6);
  for (RationalBezierPatch& patch : plane.patches.values())
    for (Vec4& p : patch.points.values()) p = {2.3 * p[0], 2.3 * p[1], 0, 1};
  const SurfaceIntersection found =
      intersect(testing::moved(torus(), motion), testing::moved(plane, motion));

  EXPECT_EQ(found.status, Status::Complete);
  ASSERT_EQ(found.curves.size(), 2);
  const double length = found.curves[0].length + found.curves[1].length;
  EXPECT_NEAR(length, 2 * std::numbers::pi * (1.4 + 0.6), 1e-6);
}

}  // namespace
}  // namespace blossom
