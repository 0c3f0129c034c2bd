// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/retry/exchanged_order.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <numbers>

#include "core/forms/surface.h"
#include "core/surface_intersection.h"
#include "tests/core/tracing/surface_pairs.h"

namespace blossom {
namespace {

BezierSurface rectangle(const Vec3& corner, const Vec3& u, const Vec3& v) {
  BezierSurface surface{{0, 1}, {0, 2}};
  RationalBezierPatch patch{Grid<Vec4>(2, 2)};
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      const Vec3 p = corner + double(i) * u + double(j) * v;
      patch.points(i, j) = {p[0], p[1], p[2], 1};
    }
  surface.patches = Grid<RationalBezierPatch>(1, 1, patch);
  return surface;
}

// From y = 0.25, on the border of the wall, to y = 1, on that of the floor.
const BezierSurface kFloor = rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
const BezierSurface kWall = rectangle({0.5, 0.25, -1}, {0, 1.75, 0}, {0, 0, 3});
// To y = 1, where both end.
const BezierSurface kLowWall = rectangle({0.5, 0.25, -1}, {0, 0.75, 0}, {0, 0, 3});

void expect_same_ends(const IntersectionCurve& curve, const IntersectionCurve& other) {
  const bool turned = distance(curve.samples.front().point, other.samples.front().point) > 1e-9;
  for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
    const std::size_t there = turned ? 1 - side : side;
    const SurfacePoint& p = side == 0 ? curve.samples.front() : curve.samples.back();
    const SurfacePoint& q = there == 0 ? other.samples.front() : other.samples.back();
    EXPECT_EQ(curve.ends[side], other.ends[there]);
    EXPECT_LE(distance(p.point, q.point), 1e-12);
    EXPECT_LE(distance(p.uv_a, q.uv_a), 1e-12);
    EXPECT_LE(distance(p.uv_b, q.uv_b), 1e-12);
  }
}

TEST(ExchangedOrder, GivesParametersAndEndsOfTheOtherOrder) {
  for (const BezierSurface& wall : {kWall, kLowWall}) {
    const SurfaceIntersection there = intersect(kFloor, wall);
    const SurfaceIntersection back = exchanged(intersect(wall, kFloor), kFloor, wall);
    ASSERT_EQ(there.curves.size(), 1);
    ASSERT_EQ(back.curves.size(), 1);
    expect_same_ends(there.curves[0], back.curves[0]);
    const IntersectionCurve& curve = back.curves[0];
    for (const double t : {0.0, 0.3, 0.7}) {
      const double at = t * curve.curve.knots.back();
      EXPECT_LE(distance(point_at(kFloor, point_at(curve.chart_a, at)), point_at(curve.curve, at)),
                1e-9);
      EXPECT_LE(distance(point_at(wall, point_at(curve.chart_b, at)), point_at(curve.curve, at)),
                1e-9);
    }
  }
}

TEST(ExchangedOrder, ExchangesPointsAndPlaces) {
  SurfaceIntersection found;
  found.points.push_back({{1, 2, 3}, {4, 5}, {6, 7}});
  found.nodes = found.points;
  Place place;
  place.parameters = {Interval{0, 1}, {2, 3}, {4, 5}, {6, 7}};
  found.places.push_back(place);

  const SurfaceIntersection other = exchanged(found, kFloor, kWall);

  EXPECT_EQ(other.points[0].uv_a, (Vec2{6, 7}));
  EXPECT_EQ(other.nodes[0].uv_b, (Vec2{4, 5}));
  EXPECT_EQ(other.places[0].parameters,
            (std::array{Interval{4, 5}, Interval{6, 7}, Interval{0, 1}, Interval{2, 3}}));
}

TEST(ExchangedOrder, IsTriedWhereSomethingStayedOpenButForALimit) {
  const auto may_gain = [](const SurfaceIntersection& found) {
    return should_retry_swapped(found, kFloor, kWall, 1e-7);
  };
  SurfaceIntersection found;
  EXPECT_FALSE(may_gain(found));
  found.status = Status::Stopped;
  EXPECT_TRUE(may_gain(found));
  found.certificate.limited = true;
  EXPECT_FALSE(may_gain(found));
}

TEST(ExchangedOrder, IsTriedWhereATouchIsNone) {
  const BezierSurface lower = rectangle({0, 0, -5e-8}, {1, 0, 0}, {0, 1, 0});
  SurfaceIntersection found;
  found.status = Status::Tolerance;
  found.points = {{{0.5, 0.5, 0}, {0.5, 1}, {0.5, 1}}};
  found.places = {{PlaceKind::Touch, {}, {}}};
  EXPECT_TRUE(should_retry_swapped(found, kFloor, lower, 1e-7));
  EXPECT_FALSE(should_retry_swapped(found, kFloor, kFloor, 1e-7));
  found.places.push_back({PlaceKind::Node, {}, {}});
  EXPECT_FALSE(should_retry_swapped(found, kFloor, lower, 1e-7));
}

TEST(ExchangedOrder, IsTriedWhereALoopMayHaveNoCusp) {
  SurfaceIntersection found;
  found.status = Status::Tolerance;
  found.places = {{PlaceKind::Cusp, {}, {}}};
  found.curves.resize(1);
  found.curves[0].samples = {{{0, 0, 0}, {}, {}}, {{1, 0, 0}, {}, {}}, {{0, 0, 0}, {}, {}}};
  EXPECT_TRUE(should_retry_swapped(found, kFloor, kWall, 1e-7));
  found.curves[0].samples.pop_back();
  EXPECT_FALSE(should_retry_swapped(found, kFloor, kWall, 1e-7));
}

TEST(ExchangedOrder, IsAGainIfItSettlesMore) {
  SurfaceIntersection stopped, other;
  stopped.status = other.status = Status::Stopped;
  EXPECT_FALSE(is_gain(stopped, other));
  other.status = Status::Tolerance;
  EXPECT_TRUE(is_gain(stopped, other));
}

// Twice the area in the parameters of a that a boundary goes round, above 0 to its left.
double area_over_a(const Overlap& overlap) {
  double sum = 0;
  for (std::size_t i = 1; i < overlap.boundary.size(); ++i) {
    const Vec2 &p = overlap.boundary[i - 1].uv_a, &q = overlap.boundary[i].uv_a;
    sum += p[0] * q[1] - p[1] * q[0];
  }
  return sum;
}

TEST(ExchangedOrder, KeepsBoundariesToTheLeftAsSeenFromTheFirstSurface) {
  const BezierSurface above = rectangle({0.25, 0.25, 0}, {1, 0, 0}, {0, 1, 0});
  const BezierSurface turned = rectangle({0.25, 0.25, 0}, {0, 1, 0}, {1, 0, 0});
  for (const BezierSurface& other : {above, turned}) {
    const SurfaceIntersection back = exchanged(intersect(other, kFloor), kFloor, other);
    ASSERT_EQ(back.overlaps.size(), 1u);
    EXPECT_NEAR(area_over_a(back.overlaps[0]), 2 * 0.75 * 1.5, 1e-9);
  }
}

// The second patch turns back from the common one, and is the larger one: on the knot line between
// them the normals of both sides are there.
TEST(ExchangedOrder, KeepsBoundariesToTheLeftAtAKink) {
  const BezierSurface whole = rectangle({-1, 0, 0}, {1, 0, 0}, {0, 1, 0});
  for (const double height : {0.1, 1.0, 10.0})
    for (const double size : {1.0, 30.0}) {
      BezierSurface folded{{0, 1, 2}, {0, 2}};
      folded.patches = Grid<RationalBezierPatch>(2, 1, whole.patches(0, 0));
      folded.patches(1, 0) =
          rectangle({0, 0, 0}, {-size, 0, size * height}, {0, 1, 0}).patches(0, 0);
      for (const bool exchanged : {false, true}) {
        const SurfaceIntersection found =
            exchanged ? intersect(whole, folded) : intersect(folded, whole);
        ASSERT_EQ(found.overlaps.size(), 1);
        EXPECT_NEAR(area_over_a(found.overlaps[0]), 4, 1e-6);
      }
    }
}

// The circle in which a torus touches a plane is a knot line of the torus.
TEST(ExchangedOrder, DoesNotMatterForTheWorkAlongAKnotLine) {
  const BezierSurface torus = testing::torus(1, 0.4);
  const BezierSurface plane = rectangle({-2, -2, 0.4}, {4, 0, 0}, {0, 4, 0});
  const SurfaceIntersection there = intersect(torus, plane), back = intersect(plane, torus);
  for (const SurfaceIntersection* found : {&there, &back}) {
    ASSERT_EQ(found->curves.size(), 1u);
    EXPECT_NEAR(found->curves[0].length, 2 * std::numbers::pi, 1e-6);
    EXPECT_TRUE(found->curves[0].tangential);
    EXPECT_EQ(found->places.size(), 1u);
  }
  EXPECT_EQ(there.certificate.certified, back.certificate.certified);
  const SurfacePoint& x = back.curves[0].samples.front();
  EXPECT_LE(distance(point_at(plane, x.uv_a), x.point), 1e-9);
  EXPECT_LE(distance(point_at(torus, x.uv_b), x.point), 1e-9);
}

// A search that its budget ends says so.
TEST(ExchangedOrder, KnowsThatABudgetEndedTheSearch) {
  EXPECT_TRUE(intersect(kFloor, kWall, {.budget = 0}).certificate.limited);
  EXPECT_FALSE(intersect(kFloor, kWall).certificate.limited);
}

}  // namespace
}  // namespace blossom
