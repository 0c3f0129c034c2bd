// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces of revolution and of extrusion that are one, told by their curves.

#include "core/curves/swept_profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "tests/support/curves.h"

namespace blossom {
namespace {

using testing::bezier;
using testing::piece;

const Ball kBall{{1, 2, 8}, 30};

Vec3 turned_about(const Vec3& p, const Vec3& centre, const Vec3& axis, double angle) {
  const Vec3 along = centre + dot(p - centre, axis) * axis, radial = p - along;
  return along + std::cos(angle) * radial + std::sin(angle) * cross(axis, radial);
}

template <class Map>
CurveSpans moved_by(CurveSpans curve, const Map& map) {
  for (CurveSpan& span : curve.spans)
    for (Vec4& p : span.curve.points) {
      const Vec3 q = map(projected(p));
      p = {q[0] * p[3], q[1] * p[3], q[2] * p[3], p[3]};
    }
  return curve;
}

// A curve beside an axis that is askew, and one in no plane with it.
const Vec3 kCentre{1, 2, 3}, kAxis = unit(Vec3{1, -2, 3});
const Vec3 kOut = unit(cross(kAxis, Vec3{1, 0, 0}));
CurveSpans meridian() {
  return bezier({kCentre + 4 * kOut, kCentre + 7 * kOut + 3 * kAxis, kCentre + 2 * kOut + 6 * kAxis,
                 kCentre + 5 * kOut + 9 * kAxis});
}

std::optional<double> turned_gap(const CurveSpans& a, const CurveSpans& b, const Vec3& centre,
                                 const Vec3& axis) {
  const auto of_a = turned_profile(a, kCentre, kAxis), of_b = turned_profile(b, centre, axis);
  return of_a && of_b ? gap_of_one_sweep(*of_a, *of_b, kBall, {}) : std::optional<double>{};
}

std::optional<double> moved_gap(const CurveSpans& a, const CurveSpans& b, const Vec3& axis) {
  const auto of_a = moved_profile(a, kAxis), of_b = moved_profile(b, axis);
  return of_a && of_b ? gap_of_one_sweep(*of_a, *of_b, kBall, {}) : std::optional<double>{};
}

TEST(SweptProfile, AMeridianTurnedAboutItsAxisSweepsTheSameSurface) {
  for (const double angle : {0.0, 0.3, 2.0, 3.14159, 5.0}) {
    const CurveSpans other =
        moved_by(meridian(), [&](const Vec3& p) { return turned_about(p, kCentre, kAxis, angle); });
    const auto gap = turned_gap(meridian(), other, kCentre, kAxis);
    ASSERT_TRUE(gap.has_value()) << angle;
    EXPECT_LT(*gap, 1e-11) << angle;
    // The axis may be written from elsewhere, and the other way round.
    EXPECT_TRUE(turned_gap(meridian(), other, kCentre + 5 * kAxis, -kAxis).has_value()) << angle;
  }
}

TEST(SweptProfile, PartsOfOneMeridianSweepOneSurfaceWhereBothAre) {
  const RationalBezierCurve whole = meridian().spans[0].curve;
  EXPECT_TRUE(turned_gap(meridian(), piece(whole, {0.7, 0.2}), kCentre, kAxis).has_value());
  EXPECT_TRUE(turned_gap(piece(whole, {0, 0.6}), piece(whole, {0.3, 1}), kCentre, kAxis));
  EXPECT_FALSE(turned_gap(piece(whole, {0, 0.4}), piece(whole, {0.5, 1}), kCentre, kAxis));
}

TEST(SweptProfile, TheGapHoldsWhatAxesAndCurvesAreMovedBy) {
  const double step = 1e-9;
  const CurveSpans aside = moved_by(meridian(), [&](const Vec3& p) { return p + step * kOut; });
  const auto along = turned_gap(meridian(), aside, kCentre + step * kOut, kAxis);
  ASSERT_TRUE(along.has_value());
  EXPECT_GE(*along, step);
  EXPECT_LT(*along, 3 * step);
  const auto wider = turned_gap(meridian(), aside, kCentre, kAxis);
  ASSERT_TRUE(wider.has_value());
  EXPECT_GE(*wider, 0.3 * step);
  EXPECT_FALSE(turned_gap(meridian(), meridian(), kCentre + 1e-3 * kOut, kAxis).has_value());
  EXPECT_FALSE(turned_gap(meridian(), meridian(), kCentre, unit(kAxis + 1e-6 * kOut)).has_value());
}

TEST(SweptProfile, MeridiansInNoPlaneWithTheirAxisOrAcrossItHaveNoProfile) {
  const Vec3 side = cross(kAxis, kOut);
  EXPECT_FALSE(turned_profile(
      bezier({kCentre + kOut + side, kCentre + 2 * kOut - side, kCentre + kAxis}), kCentre, kAxis));
  EXPECT_FALSE(
      turned_profile(bezier({kCentre - kOut, kCentre + 2 * kOut + kAxis}), kCentre, kAxis));
  EXPECT_FALSE(turned_profile(bezier({kCentre, kCentre + kAxis}), kCentre, kAxis));
  EXPECT_FALSE(moved_profile(bezier({kCentre, kCentre + kAxis}), kAxis));
}

// What is above a plane across the axis does not matter, nor which way the curve goes.
TEST(SweptProfile, CurvesThatDifferAlongTheDirectionSweepOneSurface) {
  const Vec3 y = cross(kAxis, kOut);
  const CurveSpans curve =
      bezier({kCentre, kCentre + 3 * kOut + 2 * y, kCentre + 6 * kOut - 2 * y, kCentre + 9 * kOut});
  const CurveSpans lifted = moved_by(
      curve, [&](const Vec3& p) { return p + (3 + 0.4 * dot(p - kCentre, kOut)) * kAxis; });
  for (const Vec3& axis : {kAxis, -kAxis}) {
    const auto gap = moved_gap(curve, lifted, axis);
    ASSERT_TRUE(gap.has_value());
    EXPECT_LT(*gap, 1e-11);
  }
  const RationalBezierCurve whole = lifted.spans[0].curve;
  EXPECT_TRUE(moved_gap(curve, piece(whole, {0.8, 0.1}), kAxis).has_value());
  const auto tilted = moved_gap(curve, curve, unit(kAxis + 1e-10 * kOut));
  ASSERT_TRUE(tilted.has_value());
  EXPECT_GE(*tilted, 1e-10 * kBall.radius);
  EXPECT_FALSE(moved_gap(curve, lifted, unit(kAxis + 1e-6 * kOut)).has_value());
}

// There the surface crosses itself, so that two faces may meet beside what they have in common.
TEST(SweptProfile, CurvesThatCrossThemselvesAreNotTold) {
  const Vec3 y = cross(kAxis, kOut);
  const auto loop = [&](double x, double z) { return kCentre + x * kOut + z * y; };
  const CurveSpans curve = bezier({loop(0, 0), loop(3, 2), loop(-2, 2), loop(1, 0)});
  EXPECT_FALSE(moved_gap(curve, curve, kAxis).has_value());
}

// Up to a corner both are one, then they part.
TEST(SweptProfile, CurvesThatPartAreNotOne) {
  const Vec3 y = cross(kAxis, kOut);
  const auto angle = [&](double end) {
    return testing::polygon({kCentre, kCentre + 4 * kOut, kCentre + 6 * kOut + end * y});
  };
  EXPECT_TRUE(moved_gap(angle(2), angle(2), kAxis).has_value());
  EXPECT_FALSE(moved_gap(angle(2), angle(-1), kAxis).has_value());
}

TEST(SweptProfile, ClosedCurvesMayStartAnywhere) {
  const CurveSpans from_right = testing::circle({0, 0}, 3);
  const CurveSpans elsewhere = testing::arc({0, 0}, 3, {1, 1 + 8 * std::atan(1.0)});
  const auto of_a = moved_profile(from_right, {0, 0, 1}),
             of_b = moved_profile(elsewhere, {0, 0, 1});
  ASSERT_TRUE(of_a && of_b);
  EXPECT_TRUE(gap_of_one_sweep(*of_a, *of_b, kBall, {}).has_value());
}

}  // namespace
}  // namespace blossom
