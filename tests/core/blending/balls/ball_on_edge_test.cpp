// SPDX-License-Identifier: LGPL-2.1-or-later
// Balls that roll along an edge, and touch a surface.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/base/errors.h"
#include "core/blending/balls/ball_spine.h"
#include "core/blending/balls/ball_strip.h"
#include "core/blending/balls/ball_track.h"
#include "tests/support/ball_shapes.h"

namespace blossom {
namespace {

using testing::plane_patch;

constexpr double kHalfTurn = 3;  // radians: the angles about an edge that a ball may get to

// The curve of these Bezier points with one direction all along it, over u in [0, 1].
BezierSurface edge_along(const std::vector<Vec3>& points, const Vec3& direction) {
  BezierSurface ruled{{0, 1}, {-kHalfTurn, kHalfTurn}};
  RationalBezierPatch patch{Grid<Vec4>(static_cast<int>(points.size()), 2)};
  for (int i = 0; i < patch.points.rows(); ++i)
    for (const int k : {0, 1}) {
      const Vec3 p =
          points[static_cast<std::size_t>(i)] + (k == 0 ? -kHalfTurn : kHalfTurn) * direction;
      patch.points(i, k) = {p[0], p[1], p[2], 1};
    }
  ruled.patches = Grid<RationalBezierPatch>(1, 1, patch);
  return ruled;
}

BezierSurface floor_below() {
  return plane_patch({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-5, 5}, {-5, 5});
}

// A ball of that radius on the floor leans on a line at height h: its centre is
// sqrt(r^2 - (r - h)^2) from the line, seen from above.
TEST(BallOnEdge, LeansOnALineOverAPlane) {
  const double r = 0.5, h = 0.3;
  const BezierSurface floor = floor_below(), edge = edge_along({{0, 0, h}, {2, 0, h}}, {0, 1, 0});
  const auto track =
      track_through(whole_support(floor, 1), edge_support(edge), r, {Vec2{1, 0.4}, Vec2{0.5, 0.3}});

  ASSERT_TRUE(track);
  EXPECT_NEAR(length(track->domain()), 2, 1e-12);
  EXPECT_EQ(track->ends()[0], TrackEnd::Border);
  EXPECT_EQ(track->end_supports()[0], 1);
  for (const double t : {0.0, 0.3, 1.0}) {
    const BallPoint ball = track->at(at(track->domain(), t));
    EXPECT_NEAR(ball.centre[1], std::sqrt(r * r - (r - h) * (r - h)), 1e-14);
    EXPECT_NEAR(ball.centre[2], r, 1e-14);
    EXPECT_NEAR(norm(ball.contacts[1].point - Vec3{ball.centre[0], 0, h}), 0, 1e-14);
    EXPECT_NEAR(ball.contacts[1].determinant, 1, 1e-14);
  }
}

TEST(BallOnEdge, TouchesABentEdgeAcrossIt) {
  const double r = 0.4;
  const std::vector<Vec3> points{{0, 0, 0.2}, {0.7, 0.5, 0.1}, {1.5, -0.3, 0.3}, {2, 0.2, 0.25}};
  const BezierSurface floor = floor_below(), edge = edge_along(points, {0.1, 1, 0.2});
  const auto track =
      track_through(whole_support(floor, 1), edge_support(edge), r, {Vec2{1, 0.5}, Vec2{0.5, 0.2}});

  ASSERT_TRUE(track);
  for (double t = 0; t <= 1; t += 1.0 / 32) {
    const BallPoint ball = track->at(at(track->domain(), t));
    const double u = ball.contacts[1].chart[0], w = 1 - u;
    const Vec3 point = (w * w * w) * points[0] + (3 * w * w * u) * points[1] +
                       (3 * w * u * u) * points[2] + (u * u * u) * points[3];
    const Vec3 along = (w * w) * (points[1] - points[0]) + (2 * w * u) * (points[2] - points[1]) +
                       (u * u) * (points[3] - points[2]);
    EXPECT_NEAR(distance(ball.centre, point), r, 1e-14);
    EXPECT_NEAR(dot(ball.centre - point, along), 0, 1e-14);
    EXPECT_NEAR(ball.centre[2], r, 1e-14);
    EXPECT_NEAR(distance(ball.contacts[1].point, point), 0, 1e-14);
  }
}

// y = a x^2 at height h: in its vertex the radius of curvature is 1 / (2 a), and the ball's centre
// is sqrt(r^2 - (r - h)^2) inside.
TEST(BallOnEdge, PinchesWhereTheEdgeIsBentMore) {
  const double r = 0.5, h = 0.4, inside = std::sqrt(r * r - (r - h) * (r - h));
  for (const double a : {0.5, 0.99 / (2 * inside), 1.01 / (2 * inside)}) {
    const BezierSurface floor = floor_below(),
                        edge =
                            edge_along({{-2, 4 * a, h}, {0, -4 * a, h}, {2, 4 * a, h}}, {0, 0, 1});
    const auto track = track_through(whole_support(floor, 1), edge_support(edge), r,
                                     {Vec2{0, inside}, Vec2{0.5, -1.3}});

    ASSERT_TRUE(track) << a;
    const BallPoint ball = track->at(track->nearest({0, inside, r}));
    EXPECT_NEAR(ball.contacts[1].determinant, 1 - 2 * a * inside, 1e-10) << a;
    const BallSpine spine = with_stretches(*track);
    EXPECT_EQ(spine.cusps.empty(), 2 * a * inside < 1) << a;
  }
}

TEST(BallOnEdge, LeavesAStripThatBeginsAtTheEdge) {
  const double r = 0.4;
  const BezierSurface floor = floor_below(),
                      edge = edge_along(
                          {{0, 0, 0.2}, {0.7, 0.5, 0.1}, {1.5, -0.3, 0.3}, {2, 0, 0.2}}, {0, 1, 0});
  const auto track =
      track_through(whole_support(floor, 1), edge_support(edge), r, {Vec2{1, 0.5}, Vec2{0.5, 0.2}});
  ASSERT_TRUE(track);

  const BallStrip strip = ball_strip(*track, track->domain());

  for (const StripContactCurve& contact : strip.contacts) {
    EXPECT_TRUE(contact.proven);
    EXPECT_LE(contact.gap, 1e-8);
    EXPECT_LE(contact.normal_angle, 2e-7);
  }
  EXPECT_LE(strip.section_error, 1e-8);
  for (const Vec2& p : strip.contacts[1].chart.points) EXPECT_EQ(p[1], 0);
  EXPECT_THROW(ball_strip(*track, track->domain(), {.section = SectionKind::CurvatureRate}),
               InvalidInput);
  EXPECT_THROW(ball_strip(*track, track->domain(), {.section = SectionKind::Curvature}),
               InvalidInput);
}

}  // namespace
}  // namespace blossom
