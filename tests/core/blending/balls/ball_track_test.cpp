// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/balls/ball_track.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/errors.h"
#include "tests/support/ball_shapes.h"
#include "tests/support/spline_surfaces.h"
#include "tests/support/surface_changes.h"

namespace blossom {
namespace {

using testing::floor_face;
using testing::plane_patch;
using testing::wall_face;
using testing::whole_cylinder;

using std::numbers::pi;

// The ball touches both surfaces: how far it is from doing so, over the track.
double worst_contact(const BallTrack& track, int samples = 97) {
  double worst = 0;
  for (int i = 0; i <= samples; ++i) {
    const BallPoint ball = track.at(at(track.domain(), static_cast<double>(i) / samples));
    for (std::size_t k = 0; k < 2; ++k) {
      const BallContact& contact = ball.contacts[k];
      const Vec3 on = point_at(*track.supports()[k].surface, contact.chart);
      worst = std::max({worst, distance(on, contact.point),
                        distance(contact.point + ball.radius * contact.normal, ball.centre)});
    }
  }
  return worst;
}

TEST(BallTrack, BetweenPlanesRunsAlongALine) {
  for (const double angle : {0.4, pi / 2, 2.5}) {
    const BezierSurface floor = plane_patch({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 3}, {0, 10});
    const Vec3 up{0, std::cos(angle), std::sin(angle)};
    const BezierSurface wall = plane_patch({0, 0, 0}, {1, 0, 0}, up, {0, 3}, {0, 10});
    const double r = 0.3;

    const auto track = track_through(whole_support(floor, 1), whole_support(wall, -1), r,
                                     {Vec2{1, 1}, Vec2{1, 1}});

    ASSERT_TRUE(track);
    EXPECT_NEAR(length(track->domain()), 3, 1e-12);
    EXPECT_EQ(track->ends()[0], TrackEnd::Border);
    EXPECT_EQ(track->ends()[1], TrackEnd::Border);
    for (const double t : {0.0, 0.3, 1.0}) {
      const BallPoint ball = track->at(at(track->domain(), t));
      EXPECT_NEAR(ball.centre[1], r / std::tan(angle / 2), 1e-14);
      EXPECT_NEAR(ball.centre[2], r, 1e-14);
      EXPECT_NEAR(ball.contacts[0].chart[1], r / std::tan(angle / 2), 1e-14);
      EXPECT_NEAR(ball.contacts[1].chart[1], r / std::tan(angle / 2), 1e-14);
      EXPECT_NEAR(norm(ball.centre_rate), 1, 1e-12);
      EXPECT_NEAR(ball.contacts[0].determinant, 1, 1e-14);
    }
  }
}

TEST(BallTrack, RoundACylinderOnAPlateIsACircleThatStartsAtTheSeam) {
  const double R = 1.5, r = 0.4;
  const BezierSurface plate = plane_patch({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-5, 5}, {-5, 5});
  const BezierSurface cylinder = whole_cylinder(R, 3);

  const auto track = track_through(whole_support(plate, 1), whole_support(cylinder, 1), r,
                                   {Vec2{0.3, 2}, Vec2{1.3, 0.5}});

  ASSERT_TRUE(track);
  EXPECT_TRUE(track->closed());
  EXPECT_EQ(track->breaks().size(), 2U);
  const double speed = std::sqrt(0.5 * (R * R + (R + r) * (R + r)));  // of contacts, by the angle
  EXPECT_NEAR(length(track->domain()), 2 * pi * speed, 1e-8);
  const BallPoint first = track->at(track->domain().from), last = track->at(track->domain().to);
  EXPECT_NEAR(std::remainder(first.contacts[1].chart[0], 2 * pi), 0, 1e-14);
  EXPECT_NEAR(std::abs(last.contacts[1].chart[0] - first.contacts[1].chart[0]), 2 * pi, 1e-14);
  for (int i = 0; i <= 50; ++i) {
    const BallPoint ball = track->at(at(track->domain(), i / 50.0));
    EXPECT_NEAR(std::hypot(ball.centre[0], ball.centre[1]), R + r, 4e-15);
    EXPECT_NEAR(ball.centre[2], r, 1e-15);
    EXPECT_NEAR(ball.contacts[1].point[2], r, 1e-15);
  }
}

TEST(BallTrack, OfALoopThatIsCutOpenIsTheSameWayFromThere) {
  const BezierSurface plate = plane_patch({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-5, 5}, {-5, 5});
  const BezierSurface cylinder = whole_cylinder(1.5, 3);
  const auto loop = track_through(whole_support(plate, 1), whole_support(cylinder, 1), 0.4,
                                  {Vec2{0.3, 2}, Vec2{1.3, 0.5}});
  ASSERT_TRUE(loop && loop->closed());
  const double whole = length(loop->domain());
  for (const double part : {0.0, 0.3, 0.99, 1.0}) {
    const BallTrack open = loop->cut_open(part * whole);
    EXPECT_EQ(open.ends()[0], TrackEnd::Cut);
    EXPECT_FALSE(open.closed());
    EXPECT_EQ(open.domain().from, 0);
    EXPECT_NEAR(open.domain().to, whole, 1e-12);
    const double start = loop->nearest(open.at(0).centre);
    EXPECT_LT(std::abs(std::remainder(start - part * whole, whole)), 0.1 * whole);
    for (int i = 0; i <= 20; ++i) {
      const double t = whole * i / 20;
      const BallPoint ball = open.at(t), same = loop->at(std::fmod(start + t, whole));
      EXPECT_NEAR(distance(ball.centre, same.centre), 0, 1e-9) << part << " " << t;
      if (i == 0) continue;
      const double before = open.at(t - whole / 20).contacts[1].chart[0];
      EXPECT_LT(std::abs(ball.contacts[1].chart[0] - before), 1);  // it goes on through the seam
    }
  }
}

TEST(BallTrack, TouchesFreeFormFacesToRounding) {
  const BezierSurface floor = floor_face(), wall = wall_face();
  for (const double r : {0.02, 0.05, 0.1, 0.2, 0.4}) {
    const BallSupport a = whole_support(floor, 1), b = whole_support(wall, 1);
    const auto start = ball_beside_edge(a, b, r, {Vec2{0.5, 1}, Vec2{0.5, 0}});
    ASSERT_TRUE(start) << r;
    const auto track = track_through(a, b, r, *start);

    ASSERT_TRUE(track) << r;
    EXPECT_LT(worst_contact(*track), 2e-15);
    EXPECT_EQ(track->breaks().size(), 2U);
    EXPECT_EQ(track->ends()[0], TrackEnd::Border);
    EXPECT_LT(track->nodes().size(), 120U);
  }
}

TEST(BallTrack, HasRatesThatAreDerivatives) {
  const BezierSurface floor = floor_face(), wall = wall_face();
  const BallSupport a = whole_support(floor, 1), b = whole_support(wall, 1);
  const auto start = ball_beside_edge(a, b, 0.1, {Vec2{0.5, 1}, Vec2{0.5, 0}});
  ASSERT_TRUE(start);
  const auto track = track_through(a, b, 0.1, *start);
  ASSERT_TRUE(track);
  const double h = 1e-4;
  for (const double t : {0.11, 0.37, 0.83}) {
    const double s = at(track->domain(), t);
    const BallPoint here = track->at(s), before = track->at(s - h), after = track->at(s + h);
    EXPECT_LT(distance(here.centre_rate, (after.centre - before.centre) * (0.5 / h)), 1e-7);
    for (std::size_t k = 0; k < 2; ++k) {
      const BallContact& contact = here.contacts[k];
      const Vec3 rate = (after.contacts[k].point - before.contacts[k].point) * (0.5 / h);
      EXPECT_LT(distance(contact.rate, rate), 1e-7);
      EXPECT_LT(std::abs(dot(contact.rate, contact.normal)), 1e-12);
    }
    EXPECT_NEAR(0.5 * (dot(here.contacts[0].rate, here.contacts[0].rate) +
                       dot(here.contacts[1].rate, here.contacts[1].rate)),
                1, 1e-8);
  }
}

TEST(BallTrack, FollowsALawAlongTheEdge) {
  const BezierSurface floor = floor_face(), wall = wall_face();
  const BallSupport a = whole_support(floor, 1), b = whole_support(wall, 1);
  const testing::Cubic c = testing::base_cubic();
  const BallGuide guide{[&](double x) {
                          const double z = c(x, 0.5);
                          return CurveJet{{x, 0.5, z},
                                          {1, 0, 0.9 * x * x + 0.24 * 0.5 * x + 0.1375},
                                          {0, 0, 1.8 * x + 0.12}};
                        },
                        {0, 1}};
  const RadiusLaw law = RadiusLaw::linear({0, 1}, 0.03, 0.12);
  const auto start = ball_beside_edge(a, b, 0.075, {Vec2{0.5, 1}, Vec2{0.5, 0}});
  ASSERT_TRUE(start);
  const auto track = track_through(a, b, law, guide, 0.5, *start);
  ASSERT_TRUE(track);
  EXPECT_LT(worst_contact(*track), 2e-15);
  for (const double t : {0.0, 0.5, 1.0}) {
    const double x = at(track->domain(), t);
    const BallPoint ball = track->at(x);
    const CurveJet g = guide.curve(x);
    EXPECT_DOUBLE_EQ(ball.radius, 0.03 + 0.09 * x);
    EXPECT_NEAR(dot(ball.centre - g.point, g.first), 0, 1e-15);
    EXPECT_NEAR(dot(ball.contacts[0].normal, ball.centre_rate), 0.09, 1e-10);
  }
}

// A wavy floor of 5 x 5 patches with continuous curvature, and a wall across it.
TEST(BallTrack, HasBreaksWhereAContactPassesAKnotLine) {
  Grid<Vec3> net(8, 8);
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j) net(i, j) = {double(i), double(j), 0.4 * std::sin(1.7 * i + j)};
  const BezierSurface floor = testing::uniform_cubic(net, false, false);
  const BezierSurface wall = plane_patch({0, 3.6, -5}, {1, 0, 0}, {0, 0, 1}, {0, 8}, {0, 10});
  const BallSupport a = whole_support(floor, 1), b = whole_support(wall, 1);
  const auto track = track_through(a, b, 0.25, {Vec2{2.5, 2.2}, Vec2{3.5, 5.2}});
  ASSERT_TRUE(track);
  EXPECT_LT(worst_contact(*track), 1e-14);
  EXPECT_GE(track->breaks().size(), 6U);
  for (const double s : track->breaks()) {
    const BallPoint before = track->at(s, false), after = track->at(s, true);
    const Vec2& chart = before.contacts[0].chart;
    const bool on_line = std::abs(chart[0] - std::round(chart[0])) < 1e-9 ||
                         std::abs(chart[1] - std::round(chart[1])) < 1e-9;
    EXPECT_TRUE(on_line || s == track->domain().from || s == track->domain().to);
    EXPECT_LT(distance(before.centre_rate, after.centre_rate), 1e-9);
  }
}

TEST(BallTrack, KnowsPiecesOfOneSurfaceFromJoints) {
  const BezierSurface floor = testing::split_in_u(floor_face(), 0.37), wall = wall_face();
  const BallSupport a = whole_support(floor, 1), b = whole_support(wall, 1);
  const auto start = ball_beside_edge(a, b, 0.1, {Vec2{3, 1}, Vec2{0.4, 0}});
  ASSERT_TRUE(start);
  const auto track = track_through(a, b, 0.1, *start);
  ASSERT_TRUE(track);
  EXPECT_EQ(track->breaks().size(), 2U);
  EXPECT_LT(worst_contact(*track), 2e-15);
}

TEST(BallTrack, FindsTheBallNearestToAPoint) {
  const BezierSurface floor = floor_face(), wall = wall_face();
  const BallSupport a = whole_support(floor, 1), b = whole_support(wall, 1);
  const auto track = track_through(a, b, 0.1, {Vec2{0.5, 0.8}, Vec2{0.5, 0.2}});
  ASSERT_TRUE(track);
  const double s = at(track->domain(), 0.3141);
  EXPECT_NEAR(track->nearest(track->at(s).centre), s, 1e-12);
  EXPECT_NEAR(track->nearest(track->at(s).centre, {s - 1e-3, s + 1e-3}), s, 1e-12);
  EXPECT_EQ(track->nearest(track->at(s).centre, {track->domain().from, s - 1e-3}), s - 1e-3);
  EXPECT_EQ(track->nearest(track->at(s).centre, {s + 1e-3, track->domain().to}), s + 1e-3);
}

TEST(BallTrack, IsFollowedFarFromTheOrigin) {
  testing::Motion away;
  away.shift = {1e5, -2e5, 3e4};
  const BezierSurface floor = testing::moved(testing::split_in_u(floor_face(), 0.37), away),
                      wall = testing::moved(wall_face(), away);
  const auto track = track_through(whole_support(floor, 1), whole_support(wall, 1), 0.1,
                                   {Vec2{3, 0.8}, Vec2{0.4, 0.2}});
  ASSERT_TRUE(track);
  EXPECT_LT(worst_contact(*track), 1e-9);
  EXPECT_EQ(track->ends()[0], TrackEnd::Border);
  EXPECT_EQ(track->ends()[1], TrackEnd::Border);
}

TEST(BallTrack, EndsOnTheBordersOfItsParts) {
  const BezierSurface floor = floor_face(), wall = wall_face();
  BallSupport a = whole_support(floor, 1);
  const BallSupport b = whole_support(wall, 1);
  a.part.u = {0.3, 0.6};
  const auto track = track_through(a, b, 0.1, {Vec2{0.5, 0.8}, Vec2{0.5, 0.2}});
  ASSERT_TRUE(track);
  EXPECT_EQ(track->end_supports()[0], 0);
  EXPECT_EQ(track->end_supports()[1], 0);
  const double first = track->at(track->domain().from).contacts[0].chart[0],
               last = track->at(track->domain().to).contacts[0].chart[0];
  EXPECT_DOUBLE_EQ(std::min(first, last), 0.3);
  EXPECT_DOUBLE_EQ(std::max(first, last), 0.6);
}

TEST(BallTrack, RefusesWhatIsNoSupport) {
  const BezierSurface floor = floor_face(), wall = wall_face();
  const BallSupport a = whole_support(floor, 1), b = whole_support(wall, 1);
  const std::array<Vec2, 2> start{Vec2{0.5, 0.9}, Vec2{0.5, 0.1}};
  BallSupport turned = a, outside = a;
  turned.side = 2;
  outside.part.u.to = 1.5;
  EXPECT_THROW(track_through(turned, b, 0.1, start), InvalidInput);
  EXPECT_THROW(track_through(a, outside, 0.1, start), InvalidInput);
  EXPECT_THROW(track_through({}, b, 0.1, start), InvalidInput);
  EXPECT_THROW(track_through(a, b, -0.1, start), InvalidInput);
  EXPECT_THROW(track_through(a, b, 0.0 / 0.0, start), InvalidInput);
  EXPECT_FALSE(track_through(a, b, 30, start));
}

}  // namespace
}  // namespace blossom
