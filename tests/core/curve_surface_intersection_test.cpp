// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/curve_surface_intersection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "core/base/errors.h"
#include "core/base/work_limit.h"
#include "core/forms/algebra/degree.h"
#include "core/forms/evaluation.h"
#include "tests/support/curves.h"
#include "tests/support/random.h"
#include "tests/support/solids.h"
#include "tests/support/sturm.h"

namespace blossom {
namespace {

using testing::bezier;
using testing::circle;
using testing::one_patch;
using testing::seeded;

// z over the unit square by its Bernstein coefficients.
BezierSurface height_field(int n, int m, const std::function<double(int, int)>& z) {
  RationalBezierPatch patch{Grid<Vec4>(n + 1, m + 1)};
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= m; ++j)
      patch.points(i, j) = {static_cast<double>(i) / n, static_cast<double>(j) / m, z(i, j), 1};
  return one_patch(std::move(patch));
}

RationalBezierPatch bilinear(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const auto with_weight = [](const Vec3& p) { return Vec4{p[0], p[1], p[2], 1}; };
  RationalBezierPatch patch{Grid<Vec4>(2, 2)};
  patch.points(0, 0) = with_weight(a);
  patch.points(0, 1) = with_weight(b);
  patch.points(1, 0) = with_weight(c);
  patch.points(1, 1) = with_weight(d);
  return patch;
}

BezierSurface plane() {
  return height_field(1, 1, [](int, int) { return 0.0; });
}

// A cylinder round the z axis, radius 1, z from 0 to 1, four patches.
BezierSurface cylinder() {
  const CurveSpans base = circle({0, 0}, 1);
  BezierSurface surface;
  surface.rational = true;
  surface.closed_u = true;
  surface.u_law = ParameterLaw::Angle;
  surface.v_knots = {0, 1};
  surface.patches = Grid<RationalBezierPatch>(4, 1);
  surface.u_knots = {0};
  for (int i = 0; i < 4; ++i) {
    const CurveSpan& span = base.spans[static_cast<std::size_t>(i)];
    surface.u_knots.push_back(span.place.to);
    RationalBezierPatch patch{Grid<Vec4>(3, 2)};
    for (int k = 0; k < 3; ++k) {
      const Vec4& p = span.curve.points[static_cast<std::size_t>(k)];
      patch.points(k, 0) = p;
      patch.points(k, 1) = {p[0], p[1], p[3], p[3]};
    }
    surface.patches(i, 0) = patch;
  }
  return surface;
}

void expect_on_both(const CurveSurfaceIntersection& found, const CurveSpans& curve,
                    const BezierSurface& surface) {
  for (const CurveSurfacePoint& p : found.points) {
    const double bound = p.proven ? 1e-12 : 1e-7;
    EXPECT_LE(distance(p.point, point_at(curve, p.t)), 1e-12);
    EXPECT_LE(distance(p.point, point_at(surface, p.uv)), bound);
    EXPECT_LE(p.box_t.from, p.t);
    EXPECT_LE(p.t, p.box_t.to);
  }
}

void expect_crossings(const CurveSpans& curve, const BezierSurface& surface, std::size_t count) {
  const CurveSurfaceIntersection found = intersect(curve, surface);
  EXPECT_EQ(found.status, Status::Complete);
  ASSERT_EQ(found.points.size(), count);
  for (const CurveSurfacePoint& p : found.points) EXPECT_TRUE(p.proven && !p.tangential);
  expect_on_both(found, curve, surface);
}

CurveSpans parabola_over_plane(double gap) {
  return bezier({{0.1, 0.4, 1 + gap}, {0.5, 0.5, -1 + gap}, {0.9, 0.5, 1 + gap}});
}

TEST(CurveSurfaceIntersection, LineMeetsThePlaneAtTheComputedPoint) {
  const CurveSurfaceIntersection found =
      intersect(bezier({{0.3, 0.4, -1}, {0.5, 0.5, 1}}), plane());
  EXPECT_EQ(found.status, Status::Complete);
  ASSERT_EQ(found.points.size(), 1U);
  EXPECT_NEAR(found.points[0].t, 0.5, 1e-15);
  EXPECT_NEAR(found.points[0].uv[0], 0.4, 1e-15);
  EXPECT_NEAR(found.points[0].uv[1], 0.45, 1e-15);
}

TEST(CurveSurfaceIntersection, LinesMeetACylinderTwiceOrOnceOrNever) {
  expect_crossings(bezier({{-2, 0.3, 0.5}, {2, 0.4, 0.6}}), cylinder(), 2);
  expect_crossings(bezier({{-2, 0, 0.5}, {2, 0, 0.6}}), cylinder(), 2);  // through two joins
  expect_crossings(bezier({{0, 0, 0.5}, {2, 0.4, 0.6}}), cylinder(), 1);
  expect_crossings(bezier({{-2, 1.1, 0.5}, {2, 1.1, 0.6}}), cylinder(), 0);
  const CurveSurfaceIntersection found =
      intersect(bezier({{-2, 1, 0.5}, {1.5, 1, 0.6}}), cylinder());
  EXPECT_EQ(found.status, Status::Tolerance);
  ASSERT_EQ(found.points.size(), 1U);
  EXPECT_TRUE(found.points[0].tangential);
  EXPECT_NEAR(found.points[0].point[0], 0, 1e-6);
}

TEST(CurveSurfaceIntersection, ParabolasMissTouchOrCross) {
  for (const double gap : {1e-3, 1e-6, 2e-7})
    expect_crossings(parabola_over_plane(gap), plane(), 0);
  for (const double gap : {-1e-3, -1e-6, -1e-7})
    expect_crossings(parabola_over_plane(gap), plane(), 2);
  for (const double gap : {0.0, 1e-8, 9e-8}) {
    const CurveSurfaceIntersection found = intersect(parabola_over_plane(gap), plane());
    EXPECT_EQ(found.status, Status::Tolerance);
    ASSERT_EQ(found.points.size(), 1U);
    EXPECT_TRUE(found.points[0].tangential);
    EXPECT_NEAR(found.points[0].t, 0.5, 1e-6);
    ASSERT_EQ(found.places.size(), 1U);
    EXPECT_LE(found.places[0].gap_low, gap);
    EXPECT_GE(found.places[0].gap_low, 0.85 * gap);
    EXPECT_GE(found.places[0].gap_high, gap);
    EXPECT_LE(found.places[0].gap_high, gap + 1e-12);
  }
  for (const double gap : {-1e-8, -1e-10, -1e-12})
    expect_crossings(parabola_over_plane(gap), plane(), 2);
  // Too close for a proof: a place.
  const CurveSurfaceIntersection found = intersect(parabola_over_plane(-1e-15), plane());
  EXPECT_EQ(found.status, Status::Tolerance);
  EXPECT_EQ(found.places.size(), 1U);
}

TEST(CurveSurfaceIntersection, ContactOfThirdOrderIsOneTangentialPlace) {
  const CurveSurfaceIntersection found =
      intersect(bezier({{0.1, 0.4, -1}, {0.4, 0.4, 1}, {0.6, 0.4, -1}, {0.9, 0.4, 1}}), plane());
  EXPECT_EQ(found.status, Status::Tolerance);
  ASSERT_EQ(found.points.size(), 1U);
  EXPECT_TRUE(found.points[0].tangential);
  EXPECT_NEAR(found.points[0].t, 0.5, 1e-4);
  EXPECT_EQ(found.places[0].kind, PlaceKind::Tangential);
}

TEST(CurveSurfaceIntersection, CurvesInTheSurfaceAreProvenRuns) {
  const BezierSurface saddle =
      height_field(1, 1, [](int i, int j) { return static_cast<double>(i * j); });
  for (const CurveSpans& curve :
       {bezier({{0, 0.5, 0}, {1, 0.5, 0.5}}), bezier({{0, 0, 0}, {0.5, 0.5, 0}, {1, 1, 1}})}) {
    const CurveSurfaceIntersection found = intersect(curve, saddle);
    EXPECT_EQ(found.status, Status::Tolerance);
    EXPECT_TRUE(found.points.empty());
    ASSERT_EQ(found.overlaps.size(), 1U);
    EXPECT_TRUE(found.overlaps[0].proven);
    EXPECT_LE(found.overlaps[0].gap_high, 1e-12);
    EXPECT_EQ(found.overlaps[0].t, (Interval{0, 1}));
  }
  // A circle on the cylinder, turned against its joins; and its ruling.
  const CurveSpans ring = testing::arc({0, 0}, 1, {0.4, 0.4 + 8 * std::atan(1.0)});
  CurveSpans raised = ring;
  for (CurveSpan& span : raised.spans)
    for (Vec4& p : span.curve.points) p[2] = 0.5 * p[3];
  CurveSurfaceIntersection found = intersect(raised, cylinder());
  EXPECT_EQ(found.status, Status::Tolerance);
  EXPECT_TRUE(found.points.empty());
  double length_of_runs = 0;
  for (const CurveSurfaceOverlap& run : found.overlaps) length_of_runs += length(run.t);
  EXPECT_NEAR(length_of_runs, 8 * std::atan(1.0), 1e-2);
  found = intersect(bezier({{1, 0, -1}, {1, 0, 2}}), cylinder());
  EXPECT_EQ(found.status, Status::Tolerance);
  ASSERT_EQ(found.overlaps.size(), 1U);
  EXPECT_NEAR(found.overlaps[0].t.from, 1. / 3, 1e-3);
  EXPECT_NEAR(found.overlaps[0].t.to, 2. / 3, 1e-3);
}

// However short it is beside the whole curve; and however often a curve comes back.
TEST(CurveSurfaceIntersection, ARunEndsWhereTheCurveLeavesThePatch) {
  for (const double to : {0.6, 2.5, 4.5, 40.0}) {
    const auto found = intersect(bezier({{0.5, 0.5, 0}, {to, 0.5 * to + 0.25, 0}}), plane());
    EXPECT_EQ(found.status, Status::Tolerance);
    EXPECT_TRUE(found.points.empty()) << to;
    ASSERT_EQ(found.overlaps.size(), 1U) << to;
    EXPECT_EQ(found.overlaps[0].t.from, 0);
    EXPECT_NEAR(found.overlaps[0].t.to * (to - 0.5), std::min(0.5, to - 0.5), 1e-6) << to;
  }
  const CurveSpans wave = bezier({{0.4, -1, 0}, {0.5, 5, 0}, {0.5, -4, 0}, {0.6, 2, 0}});
  const auto found = intersect(wave, plane());
  EXPECT_EQ(found.overlaps.size(), 3U);
  for (const CurveSurfaceOverlap& run : found.overlaps)
    for (const double t : {run.t.from, run.t.to}) {
      const double y = point_at(wave, t)[1];
      EXPECT_LE(std::min(std::abs(y), std::abs(y - 1)), 1e-6);
    }
  const auto beside = intersect(bezier({{-1, 1 + 1e-5, 0}, {2, 1 + 1e-6, 0}}), plane());
  EXPECT_EQ(beside.status, Status::Complete);
  EXPECT_TRUE(beside.overlaps.empty() && beside.points.empty());
}

TEST(CurveSurfaceIntersection, EndsAndBordersWithinToleranceAreListed) {
  CurveSurfaceIntersection found = intersect(bezier({{0.3, 0.4, 1}, {0.5, 0.5, 3e-8}}), plane());
  EXPECT_EQ(found.status, Status::Tolerance);
  ASSERT_EQ(found.points.size(), 1U);
  EXPECT_EQ(found.points[0].t, 1);
  EXPECT_LE(found.places[0].gap_low, 3.1e-8);
  found = intersect(bezier({{0.3, 0.4, 1}, {0.5, 0.5, 3e-7}}), plane());
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_TRUE(found.points.empty());
  found = intersect(bezier({{1, 0.4, 1}, {1, 0.5, -1}}), plane());
  EXPECT_EQ(found.status, Status::Tolerance);
  ASSERT_EQ(found.points.size(), 1U);
  EXPECT_EQ(found.points[0].uv[0], 1);
}

TEST(CurveSurfaceIntersection, BudgetStopsWithOpenPlaces) {
  IntersectionOptions options;
  options.budget = 2;
  const CurveSpans wave =
      bezier({{0.1, 0.4, -1}, {0.4, 0.4, 1.5}, {0.6, 0.4, -1.5}, {0.9, 0.4, 1}});
  const auto found = intersect(wave, plane(), options);
  EXPECT_EQ(found.status, Status::Stopped);
  EXPECT_FALSE(found.places.empty());
}

// Each point of the line is that of a whole curve of parameters, without a normal.
TEST(CurveSurfaceIntersection, BudgetEndsTheSearchForPiecesInACollapsedSurface) {
  const BezierSurface collapsed = one_patch(bilinear({0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}));
  IntersectionOptions options;
  options.budget = 1000;
  const auto found = intersect(bezier({{0.3, 0, 0}, {1.7, 0, 0}}), collapsed, options);
  EXPECT_EQ(found.status, Status::Stopped);
  EXPECT_FALSE(found.places.empty());
}

// Were it spent twice, for pieces and for points, so would be the time that was asked for.
TEST(CurveSurfaceIntersection, SpendsItsBudgetOnceOnPiecesAndPointsTogether) {
  const BezierSurface collapsed = one_patch(bilinear({0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}));
  IntersectionOptions options;
  options.budget = 1000;
  long asked = 0;
  const std::function<bool()> count = [&] { return ++asked, false; };
  options.cancelled = count;
  intersect(bezier({{0.3, 0, 0}, {1.7, 0, 0}}), collapsed, options);
  EXPECT_GT(asked, 0);
  EXPECT_LE(asked, options.budget / SharedWork::kAskEvery);
}

// The line runs along a collapsed patch, down to its smallest cells, and then pierces a plane one.
TEST(CurveSurfaceIntersection, PiecesLeaveMostOfTheBudgetToThePoints) {
  BezierSurface surface;
  surface.u_knots = {0, 1, 2};
  surface.v_knots = {0, 1};
  surface.patches = Grid<RationalBezierPatch>(2, 1);
  surface.patches(0, 0) = bilinear({0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0});
  surface.patches(1, 0) = bilinear({3, -1, -1}, {3, 1, -1}, {3, -1, 1}, {3, 1, 1});
  IntersectionOptions options;
  options.budget = 1000;
  const auto found = intersect(bezier({{0.3, 0, 0}, {4, 0, 0}}), surface, options);
  EXPECT_EQ(found.status, Status::Stopped);
  EXPECT_EQ(std::ranges::count_if(found.points,
                                  [](const CurveSurfacePoint& x) {
                                    return x.proven && std::abs(x.point[0] - 3) < 1e-12;
                                  }),
            1);
}

// Closer looks at contacts, here of third order, come last: they find a single point instead, or
// prove a gap beside it.
TEST(CurveSurfaceIntersection, SaysThatTheBudgetEndedWhereverItDoes) {
  for (const double height : {3e-8, -1e-7}) {
    const CurveSpans curve = bezier({{0.1, 0.4, height + 0.125},
                                     {0.4, 0.4, height - 0.125},
                                     {0.6, 0.4, height + 0.125},
                                     {0.9, 0.4, height - 0.125}});
    const auto whole = intersect(curve, plane());
    IntersectionOptions options;
    options.budget = 1;
    auto found = intersect(curve, plane(), options);
    for (; found.status == Status::Stopped; found = intersect(curve, plane(), options)) {
      EXPECT_EQ(found.certificate.reasons.back(), "the budget is spent");
      ASSERT_LE(++options.budget, 100000);
    }
    EXPECT_EQ(found.status, whole.status);
    EXPECT_EQ(found.points.size(), whole.points.size());
    ASSERT_EQ(found.places.size(), whole.places.size());
    for (std::size_t i = 0; i < whole.places.size(); ++i)
      EXPECT_EQ(found.places[i].gap_low, whole.places[i].gap_low);
  }
}

// Derivatives along the trapezoid's parallel sides differ much: bounds by them reach beyond it.
TEST(CurveSurfaceIntersection, ARunEndsAtTheSlantedSidesOfATrapezoid) {
  const BezierSurface trapezoid =
      one_patch(bilinear({0, 0, 0}, {1.5, 2, 0}, {4, 0, 0}, {2.5, 2, 0}));
  const auto run = intersect(bezier({{2, 1, 0}, {4, 1, 0}}), trapezoid);
  ASSERT_EQ(run.overlaps.size(), 1U);
  EXPECT_TRUE(run.points.empty());
  EXPECT_NEAR(run.overlaps[0].t.to, 0.625, 1e-6);
  const auto beside = intersect(bezier({{3.5, 1, 0}, {4.5, 1, 0}}), trapezoid);
  EXPECT_TRUE(beside.overlaps.empty());
  EXPECT_TRUE(beside.points.empty());
  EXPECT_EQ(beside.status, Status::Complete);
}

// The line leaves the patch where a piece of it ends that is proven; it stays within the tolerance
// a little farther.
TEST(CurveSurfaceIntersection, ATouchAtItsEndLeavesAProvenRunAsItIs) {
  const auto found = intersect(bezier({{0, 0.5, 0}, {2, 0.5, 0}}), plane());
  ASSERT_EQ(found.overlaps.size(), 1U);
  EXPECT_NEAR(found.overlaps[0].t.to, 0.5, 1e-6);
  EXPECT_TRUE(found.overlaps[0].proven);
  EXPECT_LE(found.overlaps[0].gap_high, 1e-12);
}

TEST(CurveSurfaceIntersection, RunsOnBothSidesOfAnotherAreOneWithIt) {
  BezierSurface surface;  // the join is no end of a piece
  surface.u_knots = {0, 0.49, 1};
  surface.v_knots = {0, 1};
  surface.patches = Grid<RationalBezierPatch>(2, 1);
  surface.patches(0, 0) = bilinear({0, 0, 0}, {0, 1, 0}, {0.49, 0, 0}, {0.49, 1, 0});
  surface.patches(1, 0) = bilinear({0.49, 0, 0}, {0.49, 1, 0}, {1, 0, 0}, {1, 1, 0});
  const auto found = intersect(bezier({{0, 0.5, 0}, {1, 0.5, 0}}), surface);
  ASSERT_EQ(found.overlaps.size(), 1U);
  EXPECT_EQ(found.overlaps[0].t, (Interval{0, 1}));
  EXPECT_EQ(found.overlaps[0].uv_to, (Vec2{1, 0.5}));
  EXPECT_TRUE(found.points.empty());
}

TEST(CurveSurfaceIntersection, RefusesBadInput) {
  EXPECT_THROW(intersect(CurveSpans{}, plane()), InvalidInput);
  EXPECT_THROW(intersect(parabola_over_plane(0), BezierSurface{}), InvalidInput);
}

// Curves (x, y, z)(t) with x and y linear over z = f(x, y) bicubic: the number of crossings is the
// number of roots of z(t) - f(x(t), y(t)), exactly.
class RandomPierces : public ::testing::TestWithParam<int> {};

using testing::ExactPolynomial;
using testing::Rational;

ExactPolynomial times(const ExactPolynomial& a, const ExactPolynomial& b) {
  ExactPolynomial p(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) p[i + j] += a[i] * b[j];
  return p;
}

// Bernstein polynomial i of degree 2 along from + t (to - from).
ExactPolynomial bernstein(int i, const Rational& from, const Rational& to) {
  const ExactPolynomial x{from, to - from}, rest{1 - from, from - to};
  ExactPolynomial p{i == 1 ? 2 : 1};
  for (int k = 0; k < 2; ++k) p = times(p, k < i ? x : rest);
  return p;
}

TEST_P(RandomPierces, HaveAsManyPointsAsTheDifferenceHasRoots) {
  auto random = seeded(GetParam());
  for (int trial = 0; trial < 20; ++trial) {
    Grid<double> z(3, 3);
    for (double& value : z.values()) value = testing::pick(random, -32, 32) / 16.0;
    BezierSurface surface = height_field(2, 2, [&](int i, int j) { return z(i, j); });
    double end[4];
    for (double& value : end) value = testing::pick(random, 1, 31) / 32.0;
    BezierCurve curve;
    std::vector<Rational> heights;
    for (int i = 0; i <= 3; ++i) {
      const double height = testing::pick(random, -24, 24) / 8.0;
      heights.emplace_back(height);
      // Thirds are no doubles: the plane coordinates go over two control points.
      curve.points.push_back(
          {end[0] + (end[2] - end[0]) * i / 3, end[1] + (end[3] - end[1]) * i / 3, height});
    }
    ExactPolynomial difference = testing::powers(heights);
    difference.resize(5);
    for (int i = 0; i <= 2; ++i)
      for (int j = 0; j <= 2; ++j) {
        const ExactPolynomial term = times(bernstein(i, Rational(end[0]), Rational(end[2])),
                                           bernstein(j, Rational(end[1]), Rational(end[3])));
        for (std::size_t k = 0; k < term.size(); ++k) difference[k] -= Rational(z(i, j)) * term[k];
      }
    if (difference[0] == 0 || testing::value(difference, 1) == 0) continue;
    const int count = testing::count_roots(difference, 0, 1);
    const CurveSpans spans = curve_spans(curve);
    const CurveSurfaceIntersection found = intersect(spans, surface);
    EXPECT_EQ(static_cast<int>(found.points.size()), count)
        << "trial " << trial << ", status " << to_string(found.status);
    expect_on_both(found, spans, surface);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomPierces, ::testing::Range(0, 50));

// The parabola_over_plane over a surface of degree (2, 1), above it by (t - c)^2 + gap at every t:
// its control points by interpolation at thirds of the height along a line in the plane.
struct CornerContact {
  BezierSurface surface;
  CurveSpans curve;
  double place;
};

CornerContact random_graze(testing::Random& random, double bend, double gap) {
  const auto uniform = [&](double low, double high) { return testing::uniform(random, low, high); };
  Grid<double> z(3, 2);
  for (double& value : z.values()) value = uniform(-1, 1);
  CornerContact result{
      height_field(2, 1, [&](int i, int j) { return z(i, j); }), {}, uniform(0.02, 0.98)};
  const Vec2 from{uniform(-0.2, 1.2), uniform(-0.2, 1.2)},
      to{uniform(-0.2, 1.2), uniform(-0.2, 1.2)};
  std::array<double, 4> height{};
  for (std::size_t i = 0; i < 4; ++i) {
    const double t = static_cast<double>(i) / 3;
    const Vec2 p = from + (to - from) * t;
    const double on_surface = point_at(result.surface.patches(0, 0), p[0], p[1])[2];
    height[i] = on_surface + bend * (t - result.place) * (t - result.place) + gap;
  }
  // The cubic with these heights at thirds.
  const double b = (-5 * height[0] + 18 * height[1] - 9 * height[2] + 2 * height[3]) / 6;
  const double c = (2 * height[0] - 9 * height[1] + 18 * height[2] - 5 * height[3]) / 6;
  std::vector<Vec3> points;
  const double coefficients[] = {height[0], b, c, height[3]};
  for (int i = 0; i < 4; ++i) {
    const Vec2 p = from + (to - from) * (i / 3.0);
    points.push_back({p[0], p[1], coefficients[i]});
  }
  result.curve = bezier(points);
  return result;
}

// How far from the border of the unit square the curve is at a parameter; negative outside.
double depth_inside(const CurveSpans& curve, double t) {
  const Vec3 p = point_at(curve, t);
  return std::min({p[0], 1 - p[0], p[1], 1 - p[1]});
}

TEST(CurveSurfaceIntersection, RandomGrazesMissTouchOrCross) {
  auto random = seeded(3);
  for (int trial = 0; trial < 300; ++trial) {
    const double bend = testing::uniform(random, 0.3, 3) * (trial % 2 == 0 ? 1 : -1);
    const double size = std::pow(10, testing::uniform(random, -10, -2));
    for (const double gap : {size, 0.0, -size}) {
      const CornerContact corner_contact = random_graze(random, bend, bend > 0 ? gap : -gap);
      const double reach = gap < 0 ? std::sqrt(size / std::abs(bend)) : 0;
      int inside = 0;
      bool clear = true;
      for (const double t : {corner_contact.place - reach, corner_contact.place + reach}) {
        const double depth = depth_inside(corner_contact.curve, t);
        clear = clear && std::abs(depth) > 1e-2 && std::abs(t) > 1e-3 && std::abs(1 - t) > 1e-3;
        inside += depth > 0 && t > 0 && t < 1;
      }
      // Touches and what is as near, twice in the list above, count once.
      if (gap >= 0) inside = gap < 8e-8 ? inside / 2 : 0;
      const bool too_near = gap > 0 && gap > 3e-8 && gap < 1e-6;
      if (!clear || too_near) continue;
      const CurveSurfaceIntersection found =
          intersect(corner_contact.curve, corner_contact.surface);
      EXPECT_EQ(static_cast<int>(found.points.size()), inside)
          << "trial " << trial << " gap " << gap;
      EXPECT_EQ(found.status == Status::Complete, inside == 0 || gap < 0) << "trial " << trial;
      expect_on_both(found, corner_contact.curve, corner_contact.surface);
    }
  }
}

TEST(CurveSurfaceIntersection, TangentsOfACylinderTouchItWhereverItsPatchesJoin) {
  const BezierSurface surface = cylinder();
  for (int k = 0; k < 64; ++k) {
    const double angle = k * std::atan(1.0) / 8;  // every eighth at a join
    const Vec3 out{std::cos(angle), std::sin(angle), 0}, along{-out[1], out[0], 0.1};
    for (const double gap : {1e-3, 1e-5, 0.0, -1e-5, -1e-9}) {
      const Vec3 middle = out * (1 + gap) + Vec3{0, 0, 0.5};
      const CurveSpans line = bezier({middle - along * 1.5, middle + along * 2});
      const CurveSurfaceIntersection found = intersect(line, surface);
      EXPECT_EQ(found.points.size(), gap > 0 ? 0U : gap < 0 ? 2U : 1U) << k << ", gap " << gap;
      expect_on_both(found, line, surface);
      if (gap == 0 && !found.points.empty()) {
        EXPECT_LE(distance(found.points[0].point, middle), 1e-6) << k;
        EXPECT_EQ(found.places.size(), 1U) << k;
      }
    }
  }
}

}  // namespace
}  // namespace blossom
