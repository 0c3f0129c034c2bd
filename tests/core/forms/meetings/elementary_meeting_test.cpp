// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "core/forms/meetings/elementary_meeting.h"

namespace blossom {
namespace {

using std::numbers::pi;
constexpr MeetingLimits kLimits{1e-10, 1e-7};
constexpr Ball kHere{{0, 0, 0}, 100};

Elementary plane_at(double z, const Vec3& normal = {0, 0, 1}) {
  return {ElementaryKind::Plane, {0, 0, z}, normal, 0, 0, 0};
}
Elementary cylinder_of(double radius, const Vec3& centre = {}, const Vec3& axis = {0, 0, 1}) {
  return {ElementaryKind::Cylinder, centre, axis, radius, 0, 0};
}
Elementary sphere_of(double radius, const Vec3& centre = {}) {
  return {ElementaryKind::Sphere, centre, {0, 0, 1}, radius, 0, 0};
}
Elementary torus_of(double radius, double minor) {
  return {ElementaryKind::Torus, {}, {0, 0, 1}, radius, minor, 0};
}
Elementary cone_of(double angle, const Vec3& apex = {}) {
  return {ElementaryKind::Cone, apex, {0, 0, 1}, 0, 0, angle};
}

// Both ways round; the points of each curve lie on both surfaces.
void expect_meeting(const Elementary& a, const Elementary& b, std::size_t curves,
                    std::size_t points, bool tangential = false) {
  for (const auto& [x, y] : {std::pair{a, b}, std::pair{b, a}}) {
    const auto found = elementary_meeting(x, y, kHere, kLimits);
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->curves.size(), curves);
    EXPECT_EQ(found->points.size(), points);
    for (const MeetingCurve& curve : found->curves) EXPECT_EQ(curve.tangential, tangential);
  }
}

TEST(ElementaryMeeting, PlanesCutRoundSurfacesInConics) {
  expect_meeting(plane_at(1), sphere_of(2), 1, 0);
  expect_meeting(plane_at(3), sphere_of(2), 0, 0);
  expect_meeting(plane_at(1), cylinder_of(2), 1, 0);
  expect_meeting(plane_at(0, {1, 0, 0}), cylinder_of(2), 2, 0);
  expect_meeting(plane_at(0, unit(Vec3{1, 0, 1})), cylinder_of(2), 1, 0);
  expect_meeting(plane_at(1), cone_of(0.5), 1, 0);
  expect_meeting(plane_at(0, {1, 0, 0}), cone_of(0.5), 2, 0);
  expect_meeting(plane_at(0.5), torus_of(5, 1), 2, 0);
  expect_meeting(plane_at(0, {1, 0, 0}), torus_of(5, 1), 2, 0);
}

TEST(ElementaryMeeting, WhatTouchesWithinTheLimitDoesSoInOnePlace) {
  for (const double gap : {-5e-8, 0.0, 5e-8}) {
    expect_meeting(plane_at(2 + gap), sphere_of(2), 0, 1);
    expect_meeting(plane_at(1 + gap), torus_of(5, 1), 1, 0, true);
    expect_meeting(sphere_of(2), sphere_of(1, {3 + gap, 0, 0}), 0, 1);
    expect_meeting(sphere_of(2), sphere_of(1, {1 + gap, 0, 0}), 0, 1);
    expect_meeting(sphere_of(2 + gap), cylinder_of(2), 1, 0, true);
    expect_meeting(cylinder_of(2), cylinder_of(1, {3 + gap, 0, 0}), 1, 0, true);
    expect_meeting(cylinder_of(2), cylinder_of(1, {1 + gap, 0, 0}), 1, 0, true);
    expect_meeting(sphere_of(1, {3 + gap, 0, 4}), cylinder_of(2), 0, 1);
    expect_meeting(cylinder_of(6 + gap), torus_of(5, 1), 1, 0, true);
  }
  expect_meeting(plane_at(0, {1, 0, 0}), cylinder_of(2, {2 + 5e-8, 0, 0}), 1, 0, true);
}

// The product of two unit vectors may round to more than 1.
TEST(ElementaryMeeting, EllipsesOfAPlaneThatHardlyTiltsAreNoHigherThanWide) {
  for (int i = 0; i < 200; ++i) {
    const double turn = 0.1 * i;
    const Vec3 axis = unit(Vec3{std::cos(turn), std::sin(turn), std::cos(3 * turn)});
    const Vec3 tilted = unit(axis + 3e-9 * unit(cross(axis, Vec3{0.3, 0.2, 1})));
    const auto found = elementary_meeting({ElementaryKind::Plane, {}, tilted, 0, 0, 0},
                                          cylinder_of(4, {}, axis), kHere, kLimits);
    ASSERT_TRUE(found.has_value());
    ASSERT_EQ(found->curves.size(), 1u);
    EXPECT_EQ(found->curves[0].conic.kind, ConicKind::Ellipse);
    EXPECT_GE(found->curves[0].conic.major, found->curves[0].conic.minor);
  }
}

TEST(ElementaryMeeting, CirclesRoundOneAxisLieOnBothSurfaces) {
  const auto found = elementary_meeting(sphere_of(5), cone_of(pi / 6, {0, 0, -1}), kHere, kLimits);
  ASSERT_TRUE(found.has_value());
  ASSERT_EQ(found->curves.size(), 2u);
  for (const MeetingCurve& curve : found->curves) {
    const double radius = curve.conic.major, height = curve.conic.centre[2];
    EXPECT_NEAR(std::hypot(radius, height), 5, 1e-14);
    EXPECT_NEAR(radius, std::abs(height + 1) * std::tan(pi / 6), 1e-14);
  }
}

TEST(ElementaryMeeting, CylindersSideBySideCrossInLinesOnBoth) {
  const auto found = elementary_meeting(cylinder_of(2), cylinder_of(3, {4, 0, 7}), kHere, kLimits);
  ASSERT_TRUE(found.has_value());
  ASSERT_EQ(found->curves.size(), 2u);
  for (const MeetingCurve& curve : found->curves) {
    const Vec3 p = curve.conic.centre;
    EXPECT_NEAR(std::hypot(p[0], p[1]), 2, 1e-14);
    EXPECT_NEAR(std::hypot(p[0] - 4, p[1]), 3, 1e-14);
  }
}

void expect_on(const Elementary& surface, const Conic& conic) {
  for (double t = 0; t < 2 * pi; t += 0.1)
    EXPECT_NEAR(height_over(surface, point_at(conic, t)).value, 0, 1e-13);
}

// Turned and moved, as all closed forms are.
TEST(ElementaryMeeting, EqualCylindersThatCrossDoSoInEllipsesOnBoth) {
  for (const double angle : {0.1, 0.7, 0.5 * pi, 3.0}) {
    const Vec3 z = unit(Vec3{1, 2, 2}), x = unit(Vec3{2, -2, 1}), centre{0.3, 0.4, 0.5};
    const Elementary a = cylinder_of(2, centre + 7 * z, z);
    const Vec3 other = std::cos(angle) * z + std::sin(angle) * x;
    const Elementary b = cylinder_of(2, centre - 3 * other, other);
    const auto found = elementary_meeting(a, b, kHere, kLimits);
    ASSERT_TRUE(found.has_value());
    ASSERT_EQ(found->curves.size(), 2u);
    ASSERT_EQ(found->nodes.size(), 2u);
    for (const MeetingCurve& curve : found->curves) {
      expect_on(a, curve.conic);
      expect_on(b, curve.conic);
      ASSERT_EQ(curve.nodes.size(), 2u);
      for (const double t : curve.nodes)
        EXPECT_LE(std::min(distance(point_at(curve.conic, t), found->nodes[0].point),
                           distance(point_at(curve.conic, t), found->nodes[1].point)),
                  1e-14);
    }
  }
}

TEST(ElementaryMeeting, PlanesThatTiltLessThanAConeCutItInAnEllipse) {
  for (const double angle : {0.1, 0.8, 1.3})
    for (const double tilt : {1e-9, 1e-8, 3e-8, 1e-5, 0.1, 0.2})
      for (const double height : {-2.0, 1.0}) {
        const Elementary plane = plane_at(height, {std::sin(tilt), 0, std::cos(tilt)});
        const Elementary cone = cone_of(angle, {0.1, 0.2, 0.3});
        const auto found = elementary_meeting(cone, plane, kHere, kLimits);
        ASSERT_TRUE(found.has_value());
        ASSERT_EQ(found->curves.size(), 1u);
        const Conic& conic = found->curves[0].conic;
        EXPECT_GE(conic.major, conic.minor);
        expect_on(plane, conic);
        expect_on(cone, conic);
      }
}

// The branches of cylinders that miss each other's axis by d pass the node at sqrt(2 r d).
TEST(ElementaryMeeting, NodesOfCylindersThatAreOneWithinTheLimitSayHowFarTheyReach) {
  const auto found = elementary_meeting(cylinder_of(100),
                                        cylinder_of(100, {0, 9e-11, 0}, {1, 0, 0}), kHere, kLimits);
  ASSERT_TRUE(found.has_value());
  ASSERT_EQ(found->nodes.size(), 2u);
  EXPECT_NEAR(found->nodes[0].gap, 9e-11, 1e-15);
  EXPECT_NEAR(found->nodes[0].reach, std::sqrt(2 * 100 * 9e-11), 1e-9);
}

TEST(ElementaryMeeting, EllipsesNoWiderThanAContactArePoints) {
  const Elementary plane = plane_at(2e-6, {std::sin(0.1), 0, std::cos(0.1)});
  const auto found = elementary_meeting(cone_of(0.01), plane, kHere, kLimits);
  ASSERT_TRUE(found.has_value());
  EXPECT_TRUE(found->curves.empty());
  ASSERT_EQ(found->points.size(), 1u);
  EXPECT_GT(found->points[0].gap, 1e-8);
}

TEST(ElementaryMeeting, SaysNothingOfToriThatAreNearlyOne) {
  Elementary moved = torus_of(5, 1.00000005);
  moved.centre = {0, 0, 9e-8};
  EXPECT_FALSE(elementary_meeting(torus_of(5, 1), moved, kHere, kLimits));
}

TEST(ElementaryMeeting, SaysNothingOfOtherPositions) {
  EXPECT_FALSE(elementary_meeting(cylinder_of(2), cylinder_of(2.1, {}, {1, 0, 0}), kHere, kLimits));
  EXPECT_FALSE(
      elementary_meeting(cylinder_of(2), cylinder_of(2, {0, 1e-3, 0}, {1, 0, 0}), kHere, kLimits));
  EXPECT_FALSE(elementary_meeting(sphere_of(2), cylinder_of(2, {1, 0, 0}), kHere, kLimits));
  EXPECT_FALSE(elementary_meeting(sphere_of(2), sphere_of(2 + 5e-8), kHere, kLimits));
  EXPECT_FALSE(elementary_meeting(plane_at(1, unit(Vec3{2, 0, 1})), cone_of(0.5), kHere, kLimits));
}

// Files round to ten digits, which is more than an exact place is off. As long as the curves are no
// farther off than half a contact, whose share of the angle they take.
TEST(ElementaryMeeting, AxesThatMissEachOtherALittleAreOneWhereNothingTouches) {
  const double off = 3e-8;
  const std::vector<std::pair<Elementary, Elementary>> pairs{
      {cylinder_of(2), cone_of(pi / 4, {off, 0, 1})},
      {sphere_of(5, {off, 0, 0}), cylinder_of(3)},
      {torus_of(5, 1), cylinder_of(5.2, {0, off, 0})},
      {plane_at(0.5, unit(Vec3{off / 6, 0, 1})), torus_of(5, 1)},
      {plane_at(off, unit(Vec3{1, 0, 0})), torus_of(5, 1)},
      {plane_at(0, unit(Vec3{1, 0, off / 100})), cylinder_of(2)},
      {plane_at(1, unit(Vec3{off / 105, 0, 1})), cone_of(0.5)},
      {cylinder_of(2), cylinder_of(3, {4, 0, 0}, unit(Vec3{off / 300, 0, 1}))}};
  for (const auto& [a, b] : pairs) {
    const auto found = elementary_meeting(a, b, kHere, kLimits);
    ASSERT_TRUE(found.has_value());
    EXPECT_TRUE(found->points.empty());
    EXPECT_FALSE(found->curves.empty());
    for (const MeetingCurve& curve : found->curves) {
      EXPECT_FALSE(curve.tangential);
      for (const double t : {0.3, 1.7, 4.0, 6.0}) {
        const Vec3 point = point_at(curve.conic, t);
        EXPECT_LE(std::abs(height_over(a, point).value), off);
        EXPECT_LE(std::abs(height_over(b, point).value), off);
      }
    }
  }
}

TEST(ElementaryMeeting, AxesThatMissEachOtherALittleAreSearchedWhereItMatters) {
  const double off = 3e-8;
  const auto is_known = [](const Elementary& a, const Elementary& b) {
    return elementary_meeting(a, b, kHere, kLimits).has_value();
  };
  EXPECT_FALSE(is_known(cylinder_of(2), cone_of(pi / 4, {2 * off, 0, 1})));    // too far
  EXPECT_FALSE(is_known(cylinder_of(2), cone_of(0.5, {off, 0, 1})));           // too flat
  EXPECT_FALSE(is_known(sphere_of(2 + 1.1e-7, {off, 0, 0}), torus_of(3, 1)));  // they may touch
  EXPECT_FALSE(is_known(cone_of(0.5), cone_of(0.9, {off, 0, 0})));             // in an apex
  EXPECT_FALSE(is_known(plane_at(0, {1, 0, 0}), cylinder_of(2, {2, 0, 0}, {off / 200, 0, 1})));
}

// Over a hundred lengths they come near each other, or do not.
TEST(ElementaryMeeting, RulingsThatHardlyCrossMissEachOtherWhereThatIsFarAway) {
  const auto meeting = [](double apex) {
    return elementary_meeting(cone_of(0.5), cone_of(0.5 + 2e-4, {0, 0, apex}), kHere, kLimits);
  };
  EXPECT_FALSE(meeting(0.001).has_value());
  ASSERT_TRUE(meeting(1).has_value());
  EXPECT_EQ(meeting(1)->curves.size(), 1u);  // of halves that face each other
}

TEST(ElementaryMeeting, AConeThatIsNearlyFlatIsAsFarFromAPlaneAsItsSlopeTakesIt) {
  const double slope = 1e-6;
  const double bound = distance_bound(plane_at(0), cone_of(pi / 2 - slope), {{0, 0, 0}, 5});
  EXPECT_GE(bound, 5 * slope * (1 - 1e-9));
  EXPECT_LE(bound, 5.001 * slope);
}

}  // namespace
}  // namespace blossom
