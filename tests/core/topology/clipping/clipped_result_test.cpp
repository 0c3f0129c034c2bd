// SPDX-License-Identifier: LGPL-2.1-or-later
// Where curves only touch the trims, on the conics that they are.
#include "core/topology/clipping/clipped_result.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "core/results/contact_places.h"
#include "core/results/hermite_curves.h"
#include "tests/support/flat_trims.h"

namespace blossom {
namespace {

using std::numbers::pi;
using testing::FlatLoops;
using testing::kSquare4;

constexpr double kPast = 1e-6;  // the curves go so far past the wires that they touch

// A conic that is fitted no better than this, by its charts; b is not asked for.
SurfaceIntersection fitted(const Conic& conic, const Interval& range, double deviation,
                           const std::function<HermiteJet(double t)>& jet) {
  constexpr int kSteps = 64;
  std::vector<HermiteJet> jets;
  for (int i = 0; i <= kSteps; ++i) jets.push_back(jet(at(range, static_cast<double>(i) / kSteps)));
  IntersectionCurve curve = hermite_curve(jets, range);
  curve.conic = conic;
  curve.length = arc_length(conic, range);
  curve.ends = {CurveEnd::BorderA, CurveEnd::BorderA};
  curve.deviation.a = deviation;
  SurfaceIntersection found;
  found.curves = {std::move(curve)};
  return found;
}

TEST(ClippedTouches, AreOnTheConicAndHaveItsParameters) {
  const FaceTrims trims = testing::square_without_disc();
  constexpr double kOff = 1e-3;
  const Vec3 centre{2, kPast - 1, 0};
  const Conic circle{ConicKind::Circle, centre + Vec3{kOff, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1, 1};
  SurfaceIntersection found = fitted(circle, {1, 2.2}, 2 * kOff, [&](double t) {
    const Vec3 point = centre + Vec3{std::cos(t), std::sin(t), 0};
    const Vec2 uv{point[0], point[1]}, rate{-std::sin(t), std::cos(t)};
    return HermiteJet{{point, uv, uv}, {{rate[0], rate[1], 0}, rate, rate}};
  });
  const std::vector<Touch> touches = clip(found, trims, nullptr);
  EXPECT_TRUE(found.curves.empty());
  ASSERT_EQ(touches.size(), 1u);
  const SurfacePoint& touch = touches.front().at;
  EXPECT_NEAR(distance(touch.point, circle.centre), 1, 1e-12);
  EXPECT_NEAR(touch.point[0], 2 + kOff, 2e-4);
  EXPECT_NEAR(touch.uv_a[0], touch.point[0], 1e-12);
  EXPECT_NEAR(touch.uv_a[1], touch.point[1], 1e-12);
}

// Along a border of the first face, of which the second one reaches over so much.
TEST(ClippedCurves, AlongABorderStayCurvesHoweverShortTheOtherFaceCutsThem) {
  for (const double reach : {1e-1, 1e-2, 1e-3, 1e-4}) {
    FlatLoops loops;
    loops.add_polygon(kSquare4);
    const FaceTrims border = testing::square_without_disc(), other = testing::trims_of(loops);
    std::vector<HermiteJet> jets;
    for (const double x : {-1.0, 5.0})
      jets.push_back({{{x, 0, 0}, {x, 0}, {x + 4 - reach, 2}}, {{1, 0, 0}, {1, 0}, {1, 0}}});
    SurfaceIntersection found;
    found.curves = {hermite_curve(jets, {-1, 5})};
    found.curves.front().length = 6;
    EXPECT_TRUE(clip(found, border, &other).empty()) << reach;
    ASSERT_EQ(found.curves.size(), 1u) << reach;
    EXPECT_NEAR(found.curves.front().length, reach, 1e-12);
  }
}

// A contact in a point of a face's surface, and of all of another one.
SurfaceIntersection touching_in(const Vec2& uv) {
  const SurfacePoint x{{uv[0], uv[1], 0}, uv, uv};
  SurfaceIntersection found;
  found.points = {x};
  found.places = {place_of(std::vector{x}, PlaceKind::Touch, 0, 1e-6)};
  found.status = Status::Tolerance;
  found.certificate.reasons = {kTouchInPlaces};
  return found;
}

TEST(ClippedContacts, AreNoReasonWhereTheyLieFarOutside) {
  SurfaceIntersection found = touching_in({2, 2});  // in the middle of the hole
  clip(found, testing::square_without_disc(), nullptr);
  EXPECT_TRUE(found.places.empty());
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_TRUE(found.certificate.reasons.empty());
}

TEST(ClippedContacts, StayAReasonWhereTheyReachIn) {
  SurfaceIntersection beside = touching_in({1 + 1e-4, 2});  // of the hole's border
  clip(beside, testing::square_without_disc(), nullptr);
  EXPECT_TRUE(beside.places.empty());
  EXPECT_EQ(beside.status, Status::Tolerance);

  SurfaceIntersection other = touching_in({2, 2});
  other.certificate.reasons.emplace_back("something else");
  clip(other, testing::square_without_disc(), nullptr);
  EXPECT_EQ(other.status, Status::Tolerance);
  EXPECT_EQ(other.certificate.reasons, std::vector<std::string>{"something else"});
}

// A disc by angle and radius, as far as 1e-3 from its middle.
constexpr double kLeast = 1e-3;

Vec3 on_disc(const Vec2& uv) { return {uv[1] * std::cos(uv[0]), uv[1] * std::sin(uv[0]), 0}; }

FaceTrims disc_by_angle() {
  testing::FlatLoops loops;
  loops.add_polygon({{0, kLeast}, {2 * pi, kLeast}, {2 * pi, 3}, {0, 3}});
  SurfaceChart chart = testing::plane_chart();
  chart.jet = [](const Vec2& uv) {
    const Vec3 out{std::cos(uv[0]), std::sin(uv[0]), 0};
    return SurfaceJet{on_disc(uv), uv[1] * Vec3{-out[1], out[0], 0}, out};
  };
  return trims_of(chart, std::move(loops.vertices), std::move(loops.loops)).value();
}

// The line is 8 radii off, sideways: as many radians by the tangent plane, more than a turn.
TEST(ClippedTouches, StayInTheirTurnBesideAPole) {
  const Conic beside{ConicKind::Line, {-kLeast, -8 * kLeast, 0}, {0, -1, 0}, {1, 0, 0}, 0, 0};
  SurfaceIntersection found = fitted(beside, {-0.04, 0.04}, 10 * kLeast, [](double t) {
    const Vec2 uv{pi + t, kLeast + kPast - 0.5 * t * t}, rate{1, -t};
    const Vec3 out{std::cos(uv[0]), std::sin(uv[0]), 0}, along{-out[1], out[0], 0};
    return HermiteJet{{on_disc(uv), uv, uv}, {rate[1] * out + uv[1] * along, rate, rate}};
  });
  const std::vector<Touch> touches = clip(found, disc_by_angle(), nullptr);
  ASSERT_EQ(touches.size(), 1u);
  EXPECT_NEAR(touches.front().at.uv_a[0], pi, 1e-3);
  EXPECT_NEAR(touches.front().at.uv_a[1], kLeast, 2 * kPast);
}

}  // namespace
}  // namespace blossom
