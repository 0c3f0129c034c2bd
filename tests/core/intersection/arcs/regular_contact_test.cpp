// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/intersection/arcs/regular_contact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/surface_intersection.h"

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

}  // namespace
}  // namespace blossom
