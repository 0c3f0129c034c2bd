// SPDX-License-Identifier: LGPL-2.1-or-later
// Turned and extruded surfaces: their points lie where closed forms put them.

#include "core/forms/spans/swept_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace blossom {
namespace {

// A tilted frame, right-handed or left-handed.
MeridianFrame tilted(double hand) {
  const Vec3 x = (1 / 3.) * Vec3{2, 1, 2}, z = (1 / 3.) * Vec3{1, 2, -2};
  return {{1, -2, 0.5}, x, hand * cross(z, x), z};
}

Vec3 placed(const MeridianFrame& frame, double angle, double radius, double height) {
  return frame.origin + (radius * std::cos(angle)) * frame.x +
         (radius * std::sin(angle)) * frame.y + height * frame.z;
}

TEST(TurnedSurface, QuarterCylinderHasHandComputedNet) {
  const MeridianFrame frame{{}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const BezierSurface found =
      turned_surface(straight_meridian(frame, 2, 0, 1, {0, 3}), {0, std::numbers::pi / 2});
  ASSERT_EQ(found.patches.rows(), 1);
  const Grid<Vec4>& net = found.patches(0, 0).points;
  EXPECT_EQ(net(0, 0), (Vec4{2, 0, 0, 1}));
  EXPECT_EQ(net(2, 1), (Vec4{0, 2, 3, 1}));
  EXPECT_NEAR(net(1, 0)[3], std::sqrt(0.5), 1e-16);
  EXPECT_NEAR(net(1, 0)[0] / net(1, 0)[3], 2, 1e-15);
  EXPECT_NEAR(net(1, 0)[1] / net(1, 0)[3], 2, 1e-15);
}

TEST(TurnedSurface, ConesAndToriHaveTheirPointsAtTheirOwnParameters) {
  for (const double hand : {1., -1.})
    for (const ArcCuts cuts : {ArcCuts::Even, ArcCuts::Shifted}) {
      const MeridianFrame frame = tilted(hand);
      const BezierSurface cone =
          turned_surface(straight_meridian(frame, 2, 0.6, 0.8, {-1, 2}), {0.2, 4}, cuts);
      const BezierSurface torus =
          turned_surface(circular_meridian(frame, 3, 1, {-1, 2}, cuts), {0.2, 4}, cuts);
      validate(cone, "cone");
      validate(torus, "torus");
      for (double u = 0.2; u <= 4; u += 0.1)
        for (double v = -1; v <= 2; v += 0.1) {
          EXPECT_LT(distance(point_at(cone, {u, v}), placed(frame, u, 2 + 0.6 * v, 0.8 * v)),
                    1e-14);
          EXPECT_LT(
              distance(point_at(torus, {u, v}), placed(frame, u, 3 + std::cos(v), std::sin(v))),
              1e-14);
        }
    }
}

TEST(TurnedSurface, WholeTurnEndsInTheBitsItBeganWith) {
  const BezierSurface sphere =
      turned_surface(circular_meridian(tilted(1), 0, 2, {-1, 1}), {1, 1 + 2 * std::numbers::pi});
  const Grid<Vec4>& first = sphere.patches(0, 0).points;
  const Grid<Vec4>& last = sphere.patches(sphere.patches.rows() - 1, 0).points;
  for (int j = 0; j <= 2; ++j) EXPECT_EQ(first(0, j), last(2, j));
}

TEST(TurnedSurface, KeepsDistanceFromTheAxisAndHeightOfItsCurve) {
  CurveSpans curve = curve_spans(BezierCurve{{{2, 0, 0}, {3, 1, 1}, {1, 2, 2}}});
  curve.error = 1e-9;
  const Vec3 origin{0.5, 0, 0}, axis{0, 0, 1};
  const BezierSurface found = turned_surface(curved_meridian(curve, origin, axis), {0, 2});
  EXPECT_EQ(found.error, 1e-9);
  for (double v = 0; v <= 1; v += 0.1) {
    const Vec3 of_curve = point_at(curve, v) - origin;
    for (double u = 0; u <= 2; u += 0.25) {
      const Vec3 p = point_at(found, {u, v}) - origin;
      EXPECT_NEAR(p[2], of_curve[2], 1e-14);
      EXPECT_NEAR(std::hypot(p[0], p[1]), std::hypot(of_curve[0], of_curve[1]), 1e-14);
    }
  }
}

TEST(ExtrudedSurface, IsTheCurveMovedAlongTheDirection) {
  const CurveSpans curve = ellipse_spans({}, {2, 0, 0}, {0, 1, 0}, {0, 3});
  const Vec3 direction{0.1, 0.2, 1};
  const BezierSurface found = extruded_surface(curve, direction, {-1, 4});
  validate(found, "extruded");
  EXPECT_EQ(found.u_law, ParameterLaw::Angle);
  for (double u = 0; u <= 3; u += 0.1)
    for (const double v : {-1., 0., 2.5, 4.})
      EXPECT_LT(distance(point_at(found, {u, v}), point_at(curve, u) + v * direction), 1e-14);
}

}  // namespace
}  // namespace blossom
