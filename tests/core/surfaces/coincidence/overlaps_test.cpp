// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/coincidence/overlaps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/forms/evaluation.h"
#include "core/subdivision/patch_subdivision.h"
#include "core/surface_intersection.h"
#include "tests/support/cubic_family.h"
#include "tests/support/shapes.h"

namespace blossom {
namespace {

using testing::constant;
using testing::cubic_pair;
using testing::CubicPair;

BezierSurface surface_of(const RationalBezierPatch& patch) {
  BezierSurface surface{{0, 1}, {0, 1}};
  surface.patches = Grid<RationalBezierPatch>(1, 1, patch);
  surface.rational = std::any_of(patch.points.values().begin(), patch.points.values().end(),
                                 [](const Vec4& p) { return p[3] != 1; });
  return surface;
}

// The graph of the base cubic over a rectangle.
BezierSurface piece(const Interval& x, const Interval& y) {
  return testing::graph(testing::base_cubic(), {x.from, y.from}, {length(x), 0}, {0, length(y)});
}

// The same surface with u and v exchanged and u' = u / (u + 2 (1 - u)) put for u.
BezierSurface disguised(const BezierSurface& surface) {
  const Grid<Vec4>& net = surface.patches(0, 0).points;
  Grid<Vec4> turned(net.columns(), net.rows());
  for (int i = 0; i < net.rows(); ++i)
    for (int j = 0; j < net.columns(); ++j)
      turned(j, i) = net(i, j) * std::pow(2.0, net.rows() - 1 - i);
  return surface_of({turned});
}

// A bilinear square in the plane z = 0.
BezierSurface square(const Vec2& centre, double half, double angle) {
  const double c = half * std::cos(angle), s = half * std::sin(angle);
  Grid<Vec4> net(2, 2);
  net(0, 0) = {centre[0] - c + s, centre[1] - s - c, 0, 1};
  net(1, 0) = {centre[0] + c + s, centre[1] + s - c, 0, 1};
  net(0, 1) = {centre[0] - c - s, centre[1] - s + c, 0, 1};
  net(1, 1) = {centre[0] + c - s, centre[1] + s + c, 0, 1};
  return surface_of({net});
}

// A cylinder of radius 1 about the z axis in `spans` arcs from `start`.
BezierSurface cylinder(int spans, double start, double sweep, const Interval& z) {
  BezierSurface surface;
  surface.v_knots = {0, 1};
  surface.rational = true;
  surface.u_law = ParameterLaw::Angle;
  surface.closed_u = sweep > 6.28;
  surface.patches = Grid<RationalBezierPatch>(spans, 1);
  for (int i = 0; i <= spans; ++i) surface.u_knots.push_back(start + i * sweep / spans);
  for (int i = 0; i < spans; ++i) {
    const double half = sweep / spans / 2, middle = start + (2 * i + 1) * half;
    const double w = std::cos(half);
    Grid<Vec4> net(3, 2);
    for (int j = 0; j < 2; ++j) {
      const double h = j == 0 ? z.from : z.to;
      net(0, j) = {std::cos(middle - half), std::sin(middle - half), h, 1};
      net(1, j) = {std::cos(middle), std::sin(middle), w * h, w};
      net(2, j) = {std::cos(middle + half), std::sin(middle + half), h, 1};
    }
    surface.patches(i, 0) = {net};
  }
  return surface;
}

// Of the boundary's projection to the x-y plane; positive if it runs anticlockwise.
double area(const Overlap& overlap) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < overlap.boundary.size(); ++i) {
    const Vec3 &p = overlap.boundary[i].point, &q = overlap.boundary[i + 1].point;
    sum += 0.5 * (p[0] * q[1] - p[1] * q[0]);
  }
  return sum;
}

double length_of(const Overlap& overlap) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < overlap.boundary.size(); ++i)
    sum += distance(overlap.boundary[i].point, overlap.boundary[i + 1].point);
  return sum;
}

int places(const SurfaceIntersection& found, PlaceKind kind) {
  return static_cast<int>(std::count_if(found.places.begin(), found.places.end(),
                                        [&](const Place& p) { return p.kind == kind; }));
}

// One overlap and nothing else; the boundary on both surfaces, closed, inside its place.
void expect_one_overlap(const SurfaceIntersection& found, const BezierSurface& a,
                        const BezierSurface& b) {
  EXPECT_EQ(found.status, Status::Tolerance);
  EXPECT_FALSE(found.certificate.reasons.empty());
  EXPECT_TRUE(found.curves.empty());
  EXPECT_TRUE(found.points.empty());
  ASSERT_EQ(found.overlaps.size(), 1u);
  EXPECT_EQ(places(found, PlaceKind::Overlap), 1);
  EXPECT_EQ(found.places.size(), 1u);
  EXPECT_LE(found.overlaps[0].gap_high, 1e-7);
  const auto& boundary = found.overlaps[0].boundary;
  EXPECT_LE(distance(boundary.front().point, boundary.back().point), 1e-12);
  for (const SurfacePoint& p : boundary) {
    EXPECT_LE(distance(point_at(a, p.uv_a), p.point), 1e-9);
    EXPECT_LE(distance(point_at(b, p.uv_b), p.point), 1e-9);
    for (int k = 0; k < 3; ++k) {
      EXPECT_GE(p.point[k], found.places[0].box_low[k]);
      EXPECT_LE(p.point[k], found.places[0].box_high[k]);
    }
  }
}

TEST(Overlaps, AllOfASurfaceWithinAnotherIsOneOverlap) {
  const CubicPair pair = cubic_pair(constant(0));

  const SurfaceIntersection found = intersect(pair.a, pair.b);

  expect_one_overlap(found, pair.a, pair.b);
  EXPECT_NEAR(area(found.overlaps[0]), 1, 1e-12);
  for (const SurfacePoint& p : found.overlaps[0].boundary)
    EXPECT_LE(std::min({p.uv_a[0], 1 - p.uv_a[0], p.uv_a[1], 1 - p.uv_a[1]}), 1e-12);
}

TEST(Overlaps, OverlapIsTheSameWithSurfacesExchanged) {
  const CubicPair pair = cubic_pair(constant(0));

  const SurfaceIntersection found = intersect(pair.b, pair.a);

  expect_one_overlap(found, pair.b, pair.a);
  EXPECT_NEAR(area(found.overlaps[0]), 1, 1e-9);
}

TEST(Overlaps, WiderThanToleranceIsNoOverlap) {
  const CubicPair pair = cubic_pair(constant(1e-5));
  EXPECT_TRUE(intersect(pair.a, pair.b).overlaps.empty());
}

TEST(Overlaps, CornerOfTwoPiecesOfOneSurfaceIsARectangle) {
  const BezierSurface a = piece({0, 0.6}, {0, 0.7});
  const BezierSurface b = piece({0.4, 1}, {0.5, 1});
  for (const BezierSurface& other : {b, disguised(b)}) {
    const SurfaceIntersection found = intersect(a, other);

    expect_one_overlap(found, a, other);
    EXPECT_NEAR(area(found.overlaps[0]), 0.2 * 0.2, 1e-9);
    Vec3 low{1e300, 1e300, 1e300}, high = -low;
    for (const SurfacePoint& p : found.overlaps[0].boundary)
      for (int k = 0; k < 2; ++k) {
        low[k] = std::min(low[k], p.point[k]);
        high[k] = std::max(high[k], p.point[k]);
      }
    EXPECT_NEAR(low[0], 0.4, 1e-9);
    EXPECT_NEAR(high[0], 0.6, 1e-9);
    EXPECT_NEAR(low[1], 0.5, 1e-9);
    EXPECT_NEAR(high[1], 0.7, 1e-9);
  }
}

TEST(Overlaps, TurnedSquaresOverlapInAnOctagon) {
  const BezierSurface a = square({0, 0}, 0.5, 0), b = square({0, 0}, 0.5, 0.25 * std::numbers::pi);

  const SurfaceIntersection found = intersect(a, b);

  expect_one_overlap(found, a, b);
  EXPECT_NEAR(area(found.overlaps[0]), 2 * (std::numbers::sqrt2 - 1), 1e-9);
}

TEST(Overlaps, SmallCornerOfASquareIsFoundBetweenSamples) {
  // The corner of b cuts a triangle off a's lower border that is narrower than its samples lie.
  const double depth = 0.004;
  const BezierSurface a = square({0, 0}, 0.5, 0);
  const BezierSurface b =
      square({0.103, -0.5 + depth - std::numbers::sqrt2 / 2}, 0.5, 0.25 * std::numbers::pi);

  const SurfaceIntersection found = intersect(a, b, {.tolerances = {.point = 1e-9}});

  expect_one_overlap(found, a, b);
  EXPECT_NEAR(area(found.overlaps[0]), depth * depth, 1e-9);
}

TEST(Overlaps, SmallPieceOfASurfaceIsNoContactPoint) {
  const BezierSurface a = piece({0, 1}, {0, 1});
  for (const double width : {2e-3, 7e-3, 9e-3}) {
    SCOPED_TRACE(width);
    const BezierSurface b = piece({0.79, 0.79 + width}, {0.31, 0.31 + width});

    const SurfaceIntersection found = intersect(a, b);

    expect_one_overlap(found, a, b);
    EXPECT_NEAR(area(found.overlaps[0]), width * width, 1e-3 * width * width);
  }
}

TEST(Overlaps, SquaresWithACommonBorderShareACurveOnly) {
  const BezierSurface a = piece({0, 0.5}, {0, 1}), b = piece({0.5, 1}, {0.2, 0.8});

  const SurfaceIntersection found = intersect(a, b);

  EXPECT_EQ(found.status, Status::Tolerance);
  EXPECT_TRUE(found.overlaps.empty());
  ASSERT_EQ(found.curves.size(), 1u);
  const IntersectionCurve& curve = found.curves[0];
  EXPECT_TRUE(curve.tangential);
  EXPECT_FALSE(curve.closed);
  EXPECT_NEAR(std::abs(curve.samples.front().point[1] - curve.samples.back().point[1]), 0.6, 1e-9);
  for (const SurfacePoint& p : curve.samples) {
    EXPECT_NEAR(p.uv_a[0], 1, 1e-12);
    EXPECT_NEAR(p.uv_b[0], 0, 1e-9);
    EXPECT_LE(distance(point_at(a, p.uv_a), point_at(b, p.uv_b)), 1e-9);
  }
}

TEST(Overlaps, PiecesThatMeetInACornerShareAPoint) {
  const BezierSurface a = piece({0, 0.5}, {0, 0.5}), b = piece({0.5, 1}, {0.5, 1});

  const SurfaceIntersection found = intersect(a, b);

  EXPECT_TRUE(found.overlaps.empty());
  EXPECT_TRUE(found.curves.empty());
  EXPECT_EQ(places(found, PlaceKind::Touch), 1);
  ASSERT_EQ(found.points.size(), 1u);
  EXPECT_LE(distance(found.points[0].point, {0.5, 0.5, testing::base_cubic()(0.5, 0.5)}), 1e-9);
}

TEST(Overlaps, PatchesOfACylinderOverlapAcrossTheirSpans) {
  const BezierSurface a = cylinder(2, 0.1, 2.5, {0, 1}), b = cylinder(3, 1, 3, {-0.5, 0.4});

  const SurfaceIntersection found = intersect(a, b);

  expect_one_overlap(found, a, b);
  EXPECT_NEAR(length_of(found.overlaps[0]), 2 * (1.6 + 0.4), 1e-3);
}

// A plane square of 3 x 3 patches, bicubic; only the middle one is raised.
BezierSurface square_with_bump() {
  BezierSurface surface{{0, 1, 2, 3}, {0, 1, 2, 3}};
  surface.patches = Grid<RationalBezierPatch>(3, 3);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      Grid<Vec4> net(4, 4);
      for (int k = 0; k < 4; ++k)
        for (int l = 0; l < 4; ++l) net(k, l) = {i + k / 3.0, j + l / 3.0, 0, 1};
      if (i == 1 && j == 1)
        for (const int k : {1, 2})
          for (const int l : {1, 2}) net(k, l)[2] = 1;
      surface.patches(i, j) = {net};
    }
  return surface;
}

TEST(Overlaps, APatchThatDiffersIsAHoleInTheOverlap) {
  const BezierSurface a = square_with_bump(), b = square({1.5, 1.5}, 1.5, 0);
  for (const bool exchanged : {false, true}) {
    const SurfaceIntersection found = exchanged ? intersect(b, a) : intersect(a, b);

    ASSERT_EQ(found.overlaps.size(), 1u);
    EXPECT_NEAR(area(found.overlaps[0]), 8, 1e-6);
  }
}

// Beside its edge the bump is within the tolerance of the flat square for a while, and soon outside
// of its box, which has no height unless the scene is turned.
TEST(Overlaps, APatchThatPartsSlowlyIsAHoleInTheOverlap) {
  BezierSurface a = square_with_bump();
  Grid<Vec4> net(7, 7);
  for (int k = 0; k < 7; ++k)
    for (int l = 0; l < 7; ++l)
      net(k, l) = {1 + k / 6.0, 1 + l / 6.0, k == 3 && l == 3 ? 2.0 : 0.0, 1};
  a.patches(1, 1) = {net};
  BezierSurface b = square({1.5, 1.5}, 1.5, 0);
  for (const bool turned : {false, true}) {
    if (turned)
      for (BezierSurface* surface : {&a, &b})
        for (RationalBezierPatch& patch : surface->patches.values())
          for (Vec4& p : patch.points.values())
            p = {0.8 * p[0] - 0.6 * p[2], p[1], 0.6 * p[0] + 0.8 * p[2], p[3]};
    for (const bool exchanged : {false, true}) {
      SCOPED_TRACE(exchanged);
      const SurfaceIntersection found = exchanged ? intersect(b, a) : intersect(a, b);

      ASSERT_EQ(found.overlaps.size(), 1u);
      EXPECT_NEAR(area(found.overlaps[0]) / (turned ? 0.8 : 1), 8, 0.1);
    }
  }
}

TEST(Overlaps, AKnotLineInsideAnOverlapBoundsNothing) {
  BezierSurface a = square_with_bump();
  for (Vec4& p : a.patches(1, 1).points.values()) p[2] = 0;
  const BezierSurface b = square({1.5, 1.5}, 1.2, 0.3);

  const SurfaceIntersection found = intersect(a, b);

  expect_one_overlap(found, a, b);
  EXPECT_LT(area(found.overlaps[0]), 2.4 * 2.4 + 1e-9);
}

// What lies beyond the knot line is narrower than a patch by far.
TEST(Overlaps, GoOnBeyondAKnotLineBeforeTheirBorder) {
  const BezierSurface whole = piece({0, 1}, {0, 1}), b = piece({0.3, 0.7}, {0.25, 0.75});
  for (const double cut : {0.74, 0.745, 0.26}) {
    SCOPED_TRACE(cut);
    BezierSurface a{{0, 1}, {0, cut, 1}};
    a.patches = subdivide(whole.patches(0, 0), a.u_knots, a.v_knots);

    const SurfaceIntersection found = intersect(a, b), exchanged = intersect(b, a);

    expect_one_overlap(found, a, b);
    expect_one_overlap(exchanged, b, a);
    EXPECT_NEAR(area(found.overlaps[0]), 0.4 * 0.5, 1e-6);
    EXPECT_NEAR(area(exchanged.overlaps[0]), 0.4 * 0.5, 1e-6);
  }
}

TEST(Overlaps, FullCylindersOverlapInABandWithTwoCircles) {
  const BezierSurface a = cylinder(4, 0, 2 * std::numbers::pi, {0, 1});
  const BezierSurface b = cylinder(3, 0.7, 2 * std::numbers::pi, {0.4, 2});

  const SurfaceIntersection found = intersect(a, b);

  ASSERT_EQ(found.overlaps.size(), 1u);
  EXPECT_EQ(found.status, Status::Tolerance);
  std::array<int, 2> count{};
  for (const SurfacePoint& p : found.overlaps[0].boundary) {
    const bool upper = std::abs(p.point[2] - 1) < 1e-9;
    EXPECT_TRUE(upper || std::abs(p.point[2] - 0.4) < 1e-9);
    ++count[upper ? 1 : 0];
  }
  EXPECT_GE(count[0], 48);
  EXPECT_GE(count[1], 48);
}

// Cancelled at any of its questions it ends soon: no half of a boundary is given out, and what was
// not finished is a listed place.
TEST(Overlaps, StopWheneverTheyAreCancelled) {
  const BezierSurface a = cylinder(4, 0, 2 * std::numbers::pi, {0, 1});
  const BezierSurface b = cylinder(3, 0.7, 2 * std::numbers::pi, {0.4, 2});
  int questions = 0;
  intersect(a, b, {.cancelled = [&] { return ++questions < 0; }});
  ASSERT_GE(questions, 30);  // borders are followed for many points

  for (int last = 1; last <= questions; last += 7) {
    int asked = 0;
    const SurfaceIntersection found =
        intersect(a, b, {.cancelled = [&] { return ++asked >= last; }});
    EXPECT_EQ(found.status, Status::Stopped);
    const auto& reasons = found.certificate.reasons;
    EXPECT_NE(std::find(reasons.begin(), reasons.end(), "cancelled"), reasons.end());
    EXPECT_LE(asked, last + 2);
    EXPECT_FALSE(found.places.empty());
    for (const Overlap& overlap : found.overlaps) EXPECT_TRUE(overlap.boundary.empty());
  }
}

// A patch that is but a curve, u + v growing along it, has no tangent plane anywhere: charts are
// looked for in ever smaller parts of it, and in no more than the budget of cells allows.
TEST(Overlaps, OfAPatchThatIsACurveEndSoonAndListThePlace) {
  const BezierSurface plane = square({0.5, 0.5}, 0.6, 0.1);
  for (const double bend : {0.0, 0.05}) {
    Grid<Vec4> net(4, 4);
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        const double x = 0.1 + 0.4 * (i + j) / 3.0;
        net(i, j) = {x, 0.3 + bend * (x - 0.5) * (x - 0.5), 0, 1};
      }
    const BezierSurface curve = surface_of({net});

    const SurfaceIntersection found = intersect(plane, curve);

    EXPECT_NE(found.status, Status::Complete);
    ASSERT_FALSE(found.places.empty());
    for (const double t : {0.1, 0.5, 0.9}) {
      const Vec3 p = point_at(curve.patches(0, 0), t, t);
      EXPECT_TRUE(std::ranges::any_of(found.places,
                                      [&](const Place& place) {
                                        for (int k = 0; k < 3; ++k)
                                          if (p[k] < place.box_low[k] - 1e-7 ||
                                              p[k] > place.box_high[k] + 1e-7)
                                            return false;
                                        return true;
                                      }))
          << bend << ' ' << t;
    }
  }
}

}  // namespace
}  // namespace blossom
