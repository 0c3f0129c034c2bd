// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces made by closed forms are recognised from their nets, and what is none of them is not.

#include "core/forms/meetings/recognition.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "core/forms/spans/swept_surface.h"
#include "tests/support/random.h"

namespace blossom {
namespace {

using std::numbers::pi;
using testing::Random;
using testing::seeded;
using testing::uniform;

constexpr double kWithin = 1e-10;

// A frame anywhere.
MeridianFrame drawn_frame(Random& random, double reach) {
  MeridianFrame frame;
  for (int k = 0; k < 3; ++k) frame.origin[k] = uniform(random, -reach, reach);
  frame.z = unit(Vec3{uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, 0.1, 1)});
  frame.x = unit(across(
      Vec3{uniform(random, -1, 1), uniform(random, 0.1, 1), uniform(random, -1, 1)}, frame.z));
  frame.y = cross(frame.z, frame.x);
  return frame;
}

Interval drawn_angles(Random& random) {
  const double from = uniform(random, -pi, pi);
  return {from, from + uniform(random, 0.4, 2 * pi)};
}

// Largest distance of points of a surface from an elementary one.
double largest_distance(const BezierSurface& surface, const Elementary& from) {
  constexpr int kPlaces = 40;
  double largest = 0;
  for (int i = 0; i <= kPlaces; ++i)
    for (int j = 0; j <= kPlaces; ++j) {
      const Vec2 uv{at({surface.u_knots.front(), surface.u_knots.back()}, i / double{kPlaces}),
                    at({surface.v_knots.front(), surface.v_knots.back()}, j / double{kPlaces})};
      largest = std::max(largest, std::abs(height_over(from, point_at(surface, uv)).value));
    }
  return largest;
}

// What is recognised is of this kind, with these numbers, and as near as its bound says.
void expect_recognised(const BezierSurface& surface, ElementaryKind kind, double radius,
                       double minor, double angle) {
  const auto found = recognised(surface, kWithin);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->elementary.kind, kind);
  EXPECT_NEAR(found->elementary.radius, radius, 1e-10);
  EXPECT_NEAR(found->elementary.minor, minor, 1e-10);
  EXPECT_NEAR(found->elementary.angle, angle, 1e-10);
  EXPECT_LE(found->gap, kWithin);
  EXPECT_LE(largest_distance(surface, found->elementary), found->gap);
}

TEST(RecognisedSurface, CylindersConesSpheresAndToriHaveTheirRadiiAndAngles) {
  Random random = seeded(5);
  for (int n = 0; n < 50; ++n) {
    const MeridianFrame frame = drawn_frame(random, 20);
    const Interval turn = drawn_angles(random);
    const double radius = uniform(random, 0.5, 5), slope = uniform(random, 0.1, 2);
    SCOPED_TRACE(n);
    expect_recognised(turned_surface(straight_meridian(frame, radius, 0, 1, {-2, 3}), turn),
                      ElementaryKind::Cylinder, radius, 0, 0);
    expect_recognised(turned_surface(straight_meridian(frame, radius, slope, 1, {0.2, 3}), turn),
                      ElementaryKind::Cone, 0, 0, std::atan(slope));
    expect_recognised(
        turned_surface(circular_meridian(frame, 0, radius, {-1.2, uniform(random, -0.8, 1.5)}),
                       turn),
        ElementaryKind::Sphere, radius, 0, 0);
    const double minor = radius * uniform(random, 0.1, 0.9);
    expect_recognised(
        turned_surface(circular_meridian(frame, radius, minor, drawn_angles(random)), turn),
        ElementaryKind::Torus, radius, minor, 0);
  }
}

TEST(RecognisedSurface, ConesAreThoseToTheirApexAndSpheresToTheirPoles) {
  Random random = seeded(6);
  for (int n = 0; n < 20; ++n) {
    const MeridianFrame frame = drawn_frame(random, 5);
    expect_recognised(turned_surface(straight_meridian(frame, 0, 0.5, 1, {0, 3}), {0, 2 * pi}),
                      ElementaryKind::Cone, 0, 0, std::atan(0.5));
    expect_recognised(
        turned_surface(circular_meridian(frame, 0, 2, {-pi / 2, pi / 2}), {0, 2 * pi}),
        ElementaryKind::Sphere, 2, 0, 0);
  }
}

TEST(RecognisedSurface, PlanesAreThoseWhateverTheirParameters) {
  const MeridianFrame frame{{1, 2, 3}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const auto found =
      recognised(turned_surface(straight_meridian(frame, 1, 1, 0, {0.5, 3}), {0, 2 * pi}), kWithin);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->elementary.kind, ElementaryKind::Plane);
  EXPECT_NEAR(std::abs(found->elementary.axis[2]), 1, 1e-15);
  EXPECT_NEAR(found->elementary.centre[2], 3, 1e-14);
}

// Files round coordinates, which turns the normals of small patches.
TEST(RecognisedSurface, PlanesMayBeRounded) {
  Random random = seeded(9);
  const MeridianFrame frame = drawn_frame(random, 5);
  BezierSurface surface = turned_surface(straight_meridian(frame, 1, 1, 0, {0.5, 3}), {0, 2});
  for (RationalBezierPatch& patch : surface.patches.values())
    for (Vec4& p : patch.points.values())
      for (int k = 0; k < 3; ++k) p[k] += uniform(random, -1e-11, 1e-11);
  const auto found = recognised(surface, kWithin);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->elementary.kind, ElementaryKind::Plane);
  EXPECT_LE(largest_distance(surface, found->elementary), found->gap);
}

// The middle of one patch is moved by a hundredth of what is allowed, and by ten times that.
TEST(RecognisedSurface, IsNoneIfOneControlPointIsOffByMoreThanTheBound) {
  Random random = seeded(7);
  for (const double off : {0.01 * kWithin, 10 * kWithin}) {
    const MeridianFrame frame = drawn_frame(random, 5);
    BezierSurface surface =
        turned_surface(circular_meridian(frame, 3, 1, {0, 2 * pi}), {0, 2 * pi});
    const auto before = recognised(surface, kWithin);
    ASSERT_TRUE(before);
    Vec4& point = surface.patches(1, 2).points(1, 1);
    const Vec3 rise =
        height_over(before->elementary, point_at(surface, {1.5 * pi / 2, 2.5 * pi / 2})).rise;
    for (int k = 0; k < 3; ++k) point[k] += 4 * off * rise[k];
    const auto found = recognised(surface, kWithin);
    EXPECT_EQ(found.has_value(), off < kWithin);
    if (found) {
      EXPECT_GT(found->gap, before->gap);
    }
  }
}

TEST(RecognisedSurface, IsNoneOfSurfacesThatOnlyLookAlike) {
  Random random = seeded(8);
  const MeridianFrame frame = drawn_frame(random, 5);
  const CurveSpans ellipse =
      ellipse_spans(frame.origin + 3 * frame.x, 1.2 * frame.x, frame.z, {0, 2 * pi});
  EXPECT_FALSE(recognised(
      turned_surface(curved_meridian(ellipse, frame.origin, frame.z), {0, 2 * pi}), kWithin));
  EXPECT_FALSE(recognised(extruded_surface(ellipse, frame.y, {0, 2}), kWithin));
  // A circle that is drawn along a direction not perpendicular to it is no cylinder.
  const CurveSpans circle = ellipse_spans(frame.origin, frame.x, frame.z, {0, 2 * pi});
  EXPECT_FALSE(
      recognised(extruded_surface(circle, unit(frame.y + 0.01 * frame.x), {0, 2}), kWithin));
  EXPECT_TRUE(recognised(extruded_surface(circle, frame.y, {0, 2}), kWithin));
}

}  // namespace
}  // namespace blossom
