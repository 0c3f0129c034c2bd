// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tracing/deviation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/errors.h"
#include "core/surface_intersection.h"
#include "tests/core/tracing/surface_pairs.h"
#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::plane;
using testing::seeded;
using testing::surface_pairs;
using testing::SurfacePair;
using testing::uniform;

// The largest distances at many parameters of every span.
Deviation sampled(const IntersectionCurve& curve, const BezierSurface& a, const BezierSurface& b,
                  int per_span) {
  Deviation largest;
  const auto& knots = curve.curve.knots;
  for (std::size_t span = 0; span + 1 < knots.size(); ++span)
    for (int i = 0; i <= per_span; ++i) {
      const double t =
          at(Interval{knots[span], knots[span + 1]}, i / static_cast<double>(per_span));
      const Vec3 on_spline = point_at(curve.curve, t);
      const Vec3 x = curve.conic ? point_at(*curve.conic, t) : on_spline;
      largest.conic = std::max(largest.conic, distance(x, on_spline));
      const Vec3 p = point_at(a, point_at(curve.chart_a, t)),
                 q = point_at(b, point_at(curve.chart_b, t));
      largest.a = std::max(largest.a, distance(x, p));
      largest.b = std::max(largest.b, distance(x, q));
      largest.between = std::max(largest.between, distance(p, q));
    }
  return largest;
}

// A bound is no less than any sample, and at most twice the largest of them above 1e-9.
void expect_close_bounds(const Deviation& bound, const Deviation& seen) {
  constexpr double kRounding = 1e-14;  // of the samples
  EXPECT_TRUE(bound.proven);
  for (const auto& [b, s] : {std::pair{bound.a, seen.a},
                             {bound.b, seen.b},
                             {bound.between, seen.between},
                             {bound.conic, seen.conic}}) {
    EXPECT_GE(b, s - kRounding);
    EXPECT_LE(b, 2 * std::max(s, 1e-9));
  }
}

// The segment (t, 0, 0) and its charts on two planes that hold it.
IntersectionCurve segment() {
  IntersectionCurve curve;
  curve.curve = {5, {0, 1}, {6, 6}, {}};
  curve.chart_a = curve.chart_b = {5, {0, 1}, {6, 6}, {}};
  for (int i = 0; i <= 5; ++i) {
    curve.curve.points.push_back({i / 5.0, 0, 0});
    curve.chart_a.points.push_back({i / 5.0, 0.5});
    curve.chart_b.points.push_back({i / 5.0, 0.5});
  }
  return curve;
}

const BezierSurface kFloor = plane({0, -0.5, 0}, {1, 0, 0}, {0, 1, 0});
const BezierSurface kWall = plane({0, 0, -0.5}, {1, 0, 0}, {0, 0, 1});

TEST(ProvenDeviation, OfAnExactCurveIsRoundingOnly) {
  const Deviation found = proven_deviation(segment(), kFloor, kWall);

  EXPECT_TRUE(found.proven);
  EXPECT_LE(std::max({found.a, found.b, found.between}), 5e-13);
}

TEST(ProvenDeviation, OfShiftedImagesIsTheirShift) {
  IntersectionCurve curve = segment();
  for (Vec2& p : curve.chart_a.points) p[1] += 3e-4;  // along y
  for (Vec3& p : curve.curve.points) p[2] += 4e-4;

  const Deviation found = proven_deviation(curve, kFloor, kWall);

  EXPECT_NEAR(found.a, 5e-4, 5e-13);
  EXPECT_NEAR(found.b, 4e-4, 5e-13);
  EXPECT_NEAR(found.between, 3e-4, 5e-13);
}

// The conic counts, at equal parameters: the images are where the segment is, not the line.
TEST(ProvenDeviation, IsThatOfTheConic) {
  IntersectionCurve curve = segment();
  const Vec3 across = unit(Vec3{3, 4, 0}), along{0.8, -0.6, 0};
  curve.conic = Conic{ConicKind::Circle, {0, 0, -0.3}, across, along, 2, 2};
  const auto off = [&](double t) { return distance(point_at(*curve.conic, t), {t, 0, 0}); };
  double largest = 0;
  for (int i = 0; i <= 1000; ++i) largest = std::max(largest, off(i / 1000.0));

  const Deviation found = proven_deviation(curve, kFloor, kWall);

  for (const double bound : {found.a, found.b, found.conic}) {
    EXPECT_GE(bound, largest);
    EXPECT_LE(bound, 1.3 * largest);
  }
  EXPECT_LE(found.between, 5e-13);

  curve.conic = Conic{ConicKind::Line, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0, 0};
  const Deviation line = proven_deviation(curve, kFloor, kWall);
  EXPECT_LE(std::max({line.a, line.b, line.conic}), 5e-13);
}

// One pole off by d: a bump of d B_3(t), largest at 3/5, where no end of a piece is.
TEST(ProvenDeviation, OfABumpIsItsHeight) {
  IntersectionCurve curve = segment();
  curve.curve.points[3][1] += 1e-3;
  const double height = 1e-3 * 10 * 0.6 * 0.6 * 0.6 * 0.4 * 0.4;

  const Deviation found = proven_deviation(curve, kFloor, kWall);

  EXPECT_GE(found.a, height);
  EXPECT_LE(found.a, 1.3 * height);
}

// Control points that swing from side to side are far above the function: halving has to help.
TEST(ProvenDeviation, OfASwingingPolygonIsCloseToTheCurve) {
  IntersectionCurve curve = segment();
  for (std::size_t i = 1; i < 5; ++i) curve.curve.points[i][1] += i % 2 == 0 ? 1e-3 : -1e-3;
  const Deviation seen = sampled(curve, kFloor, kWall, 1000);

  const Deviation found = proven_deviation(curve, kFloor, kWall);

  EXPECT_GE(found.a, seen.a);
  EXPECT_LE(found.a, 1.3 * seen.a);
}

// A little outside, the curve is near the surface's continuation; its image stays on the border.
TEST(ProvenDeviation, CountsTheWayToTheBorderOfTheSurface) {
  IntersectionCurve curve = segment();
  for (std::size_t i = 0; i <= 5; ++i) {
    curve.curve.points[i][0] *= 1.0005;
    curve.chart_a.points[i][0] *= 1.0005;
  }
  const Deviation found = proven_deviation(curve, kFloor, kWall);

  EXPECT_TRUE(found.proven);
  EXPECT_GE(found.a, 5e-4);
  EXPECT_LE(found.a, 2e-3);
}

// Two patches: where a curve touches the line between them its control points alone cross it.
TEST(ProvenDeviation, OfACurveThatTouchesAKnotLineIsNoMore) {
  const BezierSurface left = plane({0, -0.5, 0}, {0.5, 0, 0}, {0, 1, 0}),
                      right = plane({0.5, -0.5, 0}, {0.5, 0, 0}, {0, 1, 0});
  BezierSurface floor = left;
  floor.u_knots = {0, 0.5, 1};
  floor.patches = Grid<RationalBezierPatch>(2, 1);
  floor.patches(0, 0) = left.patches(0, 0);
  floor.patches(1, 0) = right.patches(0, 0);
  for (const double touch : {0.5, 0.5 + 1e-7, 0.5 - 1e-7}) {
    IntersectionCurve curve = segment();
    constexpr std::array kSquare{1.0, 0.2, -0.2, -0.2, 0.2, 1.0};  // (2t - 1)^2
    for (std::size_t i = 0; i <= 5; ++i) {
      const double x = touch + 1e-3 * kSquare[i], y = static_cast<double>(i) / 10;
      curve.curve.points[i] = {x, y, 0};
      curve.chart_a.points[i] = {x, 0.5 + y};
      curve.chart_b.points[i] = {x, 0.5};
    }
    const Deviation found = proven_deviation(curve, floor, kWall);

    EXPECT_TRUE(found.proven);
    EXPECT_LE(found.a, 1e-10);
  }
}

// What rounding adds where weights are small is measured by those, not by the largest ones.
TEST(ProvenDeviation, OfWeightsThatFallOffIsThatOfTheirPart) {
  constexpr int kDegree = 8;
  BezierSurface floor = kFloor;
  floor.rational = true;
  floor.patches(0, 0) = {Grid<Vec4>(kDegree + 1, 2)};
  for (int i = 0; i <= kDegree; ++i)
    for (int j = 0; j <= 1; ++j) {
      const double w = std::ldexp(1.0, -4 * i);
      floor.patches(0, 0).points(i, j) = {w * i / kDegree, w * (j - 0.5), 0, w};
    }
  IntersectionCurve curve = segment();
  const Vec3 start = point_at(floor, {0.99, 0.5});
  for (std::size_t i = 0; i <= 5; ++i) {
    curve.curve.points[i] = {start[0], static_cast<double>(i) / 10, 0};
    curve.chart_a.points[i] = {0.99, 0.5 + static_cast<double>(i) / 10};
  }
  EXPECT_LE(proven_deviation(curve, floor, kWall).a, 1e-10);
}

// Where a chart curve leaves the surface, its image stays on the border: that is only sampled.
TEST(ProvenDeviation, OfAChartCurveFarOutsideIsCalledSampled) {
  IntersectionCurve curve = segment();
  for (Vec2& p : curve.chart_b.points) p[0] *= 1.25;

  const Deviation found = proven_deviation(curve, kFloor, kWall);

  EXPECT_FALSE(found.proven);
  EXPECT_NEAR(found.b, 0.2, 5e-3);
  EXPECT_LE(found.a, 1e-12);
}

TEST(ProvenDeviation, RejectsSplinesThatDoNotBelongTogether) {
  IntersectionCurve curve = segment();
  curve.chart_b.knots = {0, 2};
  EXPECT_THROW(proven_deviation(curve, kFloor, kWall), InvalidInput);
  curve = segment();
  curve.chart_a.points.pop_back();
  EXPECT_THROW(proven_deviation(curve, kFloor, kWall), InvalidInput);
}

class ProvenDeviationOf : public ::testing::TestWithParam<SurfacePair> {
 protected:
  SurfaceIntersection intersection(double tolerance) const {
    IntersectionOptions options;
    options.tolerances.point = tolerance;
    return intersect(GetParam().a, GetParam().b, options);
  }
};

TEST_P(ProvenDeviationOf, BoundsEverySampleClosely) {
  for (const double tolerance : {1e-4, 1e-6, 1e-9}) {
    const SurfaceIntersection found = intersection(tolerance);
    ASSERT_FALSE(found.curves.empty());
    for (const IntersectionCurve& curve : found.curves)
      expect_close_bounds(curve.deviation, sampled(curve, GetParam().a, GetParam().b, 1000));
  }
}

// Poles moved at random: the chart curves pass knot lines beside the spline's knots.
TEST_P(ProvenDeviationOf, HoldsWhateverTheCurve) {
  auto random = seeded(7);
  for (IntersectionCurve& curve : intersection(1e-6).curves)
    for (const double size : {1e-8, 1e-5}) {
      for (std::size_t i = 1; i + 1 < curve.curve.points.size(); ++i) {
        curve.curve.points[i][2] += uniform(random, -size, size);
        curve.chart_a.points[i] += Vec2{uniform(random, -size, size), uniform(random, -size, size)};
      }
      const Deviation found = proven_deviation(curve, GetParam().a, GetParam().b);
      expect_close_bounds(found, sampled(curve, GetParam().a, GetParam().b, 200));
    }
}

INSTANTIATE_TEST_SUITE_P(Pairs, ProvenDeviationOf, ::testing::ValuesIn(surface_pairs()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace blossom
