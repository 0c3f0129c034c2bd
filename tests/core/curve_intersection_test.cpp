// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/curve_intersection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/base/errors.h"
#include "core/forms/algebra/conversion.h"
#include "tests/support/curves.h"
#include "tests/support/random.h"
#include "tests/support/shapes.h"
#include "tests/support/sturm.h"

namespace blossom {
namespace {

using testing::arc;
using testing::bezier;
using testing::circle;
using testing::in_space;
using testing::piece;
using testing::reparametrised;
using testing::seeded;

using std::numbers::pi;
const IntersectionOptions kDefault{};

double gap_at(const CurveSpans& a, const CurveSpans& b, const CurvePoint& point) {
  return distance(point_at(a, point.a), point_at(b, point.b));
}

// Every listed point is on both curves; proven ones to rounding.
void expect_on_both(const CurveIntersection& found, const CurveSpans& a, const CurveSpans& b) {
  for (const CurvePoint& p : found.points) {
    EXPECT_LE(gap_at(a, b, p), p.proven ? 1e-12 : kDefault.tolerances.point);
    EXPECT_LE(distance(p.point, point_at(a, p.a)), 1e-12);
    EXPECT_LE(p.box_a.from, p.a);
    EXPECT_LE(p.a, p.box_a.to);
    EXPECT_LE(p.box_b.from, p.b);
    EXPECT_LE(p.b, p.box_b.to);
  }
}

// In the plane, and the same turned into space.
void expect_crossings(const CurveSpans& a, const CurveSpans& b, std::size_t count) {
  for (const bool space : {false, true}) {
    const CurveSpans p = space ? in_space(a) : a, q = space ? in_space(b) : b;
    const CurveIntersection found = intersect(p, q);
    EXPECT_EQ(found.status, Status::Complete) << (space ? "space" : "plane");
    ASSERT_EQ(found.points.size(), count) << (space ? "space" : "plane");
    for (const CurvePoint& point : found.points) EXPECT_TRUE(point.proven && !point.tangential);
    expect_on_both(found, p, q);
  }
}

// One tangential contact, its place listed.
void expect_touch(const CurveSpans& a, const CurveSpans& b, const Vec3& where, double gap) {
  for (const bool space : {false, true}) {
    const CurveSpans p = space ? in_space(a) : a, q = space ? in_space(b) : b;
    const Vec3 expected = space ? testing::in_space(where) : where;
    const CurveIntersection found = intersect(p, q);
    EXPECT_EQ(found.status, Status::Tolerance);
    ASSERT_EQ(found.points.size(), 1U) << (space ? "space" : "plane");
    EXPECT_TRUE(found.points[0].tangential);
    ASSERT_EQ(found.places.size(), 1U);
    const CurvePlace& place = found.places[0];
    EXPECT_LE(place.gap_low, gap + 1e-15);
    EXPECT_GE(place.gap_high, gap - 1e-15);
    EXPECT_LE(place.gap_high - place.gap_low, 1e-12);
    for (int k = 0; k < 3; ++k) {
      EXPECT_LE(place.box_low[k], expected[k] + 1e-12);
      EXPECT_GE(place.box_high[k], expected[k] - 1e-12);
    }
    expect_on_both(found, p, q);
  }
}

CurveSpans parabola(double gap) {
  return bezier({{-1, 1 + gap, 0}, {0, -1 + gap, 0}, {1, 1 + gap, 0}});
}
CurveSpans axis() { return bezier({{-1, 0, 0}, {1.125, 0, 0}}); }

TEST(CurveIntersection, TwoDiagonalsCrossInTheMiddle) {
  const CurveIntersection found =
      intersect(bezier({{0, 0, 0}, {1, 1, 0}}), bezier({{0, 1, 0}, {1, 0, 0}}));
  EXPECT_EQ(found.status, Status::Complete);
  ASSERT_EQ(found.points.size(), 1U);
  EXPECT_NEAR(found.points[0].a, 0.5, 1e-15);
  EXPECT_NEAR(found.points[0].b, 0.5, 1e-15);
  EXPECT_NEAR(found.certificate.least_angle, pi / 2, 1e-12);
}

// T3(T3(x)) = x has nine solutions in [-1, 1]; both curves run a little beyond.
TEST(CurveIntersection, TwoCubicsHaveNineCrossings) {
  const double r = 1.05, t = 4 * r * r * r - 3 * r, s = 12 * r * r - 3;
  const std::vector<double> x{-r, -r / 3, r / 3, r};
  const std::vector<double> y{-t, -t + 2 * r * s / 3, t - 2 * r * s / 3, t};
  BezierCurve a, b;
  for (std::size_t i = 0; i < 4; ++i) {
    a.points.push_back({x[i], y[i], 0});
    b.points.push_back({y[i], x[i], 0});
  }
  expect_crossings(curve_spans(a), curve_spans(b), 9);
}

TEST(CurveIntersection, ParabolasAboveTheToleranceMissOrCross) {
  for (const double gap : {1e-3, 1e-6, 2e-7}) expect_crossings(parabola(gap), axis(), 0);
  for (const double gap : {-1e-3, -1e-6, -1e-8, -1e-10, -1e-12})
    expect_crossings(parabola(gap), axis(), 2);
}

TEST(CurveIntersection, NearTangentParabolasTouchWithTheirGap) {
  for (const double gap : {0.0, 1e-13, 1e-10, 1e-8, 9e-8})
    expect_touch(parabola(gap), axis(), {0, gap, 0}, gap);
}

// Crossings closer to each other than the tolerance are one point.
TEST(CurveIntersection, CrossingsWithinToleranceOfEachOtherAreOneTouch) {
  expect_touch(parabola(-1e-15), axis(), {0, 0, 0}, 0);
}

// Down to rounding: boxes that hold one point each have none in common.
TEST(CurveIntersection, BoxesOfProvenPointsAreDisjoint) {
  for (double depth = 1e-6; depth > 1e-15; depth *= 0.8) {
    const CurveIntersection found = intersect(parabola(-depth), axis());
    ASSERT_LE(found.points.size(), 2U);
    if (found.points.size() < 2 || !found.points[0].proven || !found.points[1].proven) {
      EXPECT_EQ(found.status, Status::Tolerance);
      continue;
    }
    EXPECT_LT(found.points[0].box_a.to, found.points[1].box_a.from) << depth;
    // The true roots: t = (1 -+ sqrt(depth)) / 2.
    for (int i = 0; i < 2; ++i) {
      const double root = 0.5 + (i == 0 ? -0.5 : 0.5) * std::sqrt(depth);
      EXPECT_LE(found.points[static_cast<std::size_t>(i)].box_a.from, root) << depth;
      EXPECT_GE(found.points[static_cast<std::size_t>(i)].box_a.to, root) << depth;
    }
  }
}

TEST(CurveIntersection, CirclesTouchOnce) {
  expect_touch(circle({0, 0}, 1), circle({1.5, 0}, 0.5), {1, 0, 0}, 0);
  expect_touch(circle({0, 0}, 1), circle({0.5, 0}, 0.5), {1, 0, 0}, 0);
  expect_touch(circle({0, 0}, 1), circle({0.4 * std::cos(1), 0.4 * std::sin(1)}, 0.6),
               {std::cos(1), std::sin(1), 0}, 0);
  expect_touch(circle({0, 0}, 1), circle({0, 1.5 + 1e-8}, 0.5), {0, 1, 0}, 1e-8);
}

TEST(CurveIntersection, CirclesCrossTwice) {
  expect_crossings(circle({0, 0}, 1), circle({0.5, 0.3}, 1), 2);
  expect_crossings(circle({0, 0}, 1), circle({1.5, 0}, 0.6), 2);
  expect_crossings(circle({0, 0}, 1), circle({1.5, 0}, 0.5 + 1e-6), 2);
  expect_crossings(circle({0, 0}, 1), circle({1.5, 0}, 0.4), 0);
  expect_crossings(circle({0, 0}, 1), circle({0.1, 0}, 0.5), 0);
}

// Contact of third and fourth order with the axis: y = x^3 changes sides, y = x^4 does not.
TEST(CurveIntersection, OsculatingCurvesMeetInOnePlace) {
  const CurveSpans cubic = bezier({{-1, -1, 0}, {-1. / 3, 1, 0}, {1. / 3, -1, 0}, {1, 1, 0}});
  const CurveSpans quartic =
      bezier({{-1, 1, 0}, {-0.5, -1, 0}, {0, 1, 0}, {0.5, -1, 0}, {1, 1, 0}});
  for (const bool third : {true, false}) {
    const CurveSpans& curve = third ? cubic : quartic;
    const CurveIntersection found = intersect(curve, axis());
    EXPECT_EQ(found.status, Status::Tolerance);
    ASSERT_EQ(found.points.size(), 1U);
    EXPECT_TRUE(found.points[0].tangential);
    EXPECT_NEAR(found.points[0].point[0], 0, 1e-3);
    ASSERT_EQ(found.places.size(), 1U);
    EXPECT_EQ(found.places[0].kind, third ? PlaceKind::Tangential : PlaceKind::Touch);
    EXPECT_EQ(found.places[0].gap_low, 0);
    EXPECT_LE(found.places[0].box_low[0], 0);
    EXPECT_GE(found.places[0].box_high[0], 0);
  }
}

TEST(CurveIntersection, LineThroughTheNodeOfALoopMeetsItTwice) {
  const CurveSpans loop = bezier({{0, 0, 0}, {3, 2, 0}, {-2, 2, 0}, {1, 0, 0}});  // node (1/2, 3/8)
  expect_crossings(loop, bezier({{0, 0.375, 0}, {1, 0.375, 0}}), 2);
  expect_crossings(loop, bezier({{0.5, 0.25, 0}, {0.5, 0.5, 0}}), 2);
}

TEST(CurveIntersection, LineMissesOrMeetsACusp) {
  const CurveSpans cusp = bezier({{1, -1, 0}, {-1. / 3, 1, 0}, {-1. / 3, -1, 0}, {1, 1, 0}});
  expect_crossings(cusp, bezier({{-1, 0.1, 0}, {1, 0.1, 0}}), 1);
  expect_crossings(cusp, bezier({{-0.1, -1, 0}, {-0.1, 1, 0}}), 0);
  const CurveIntersection found = intersect(cusp, bezier({{-1, 0.5, 0}, {1, -0.5, 0}}));
  ASSERT_FALSE(found.points.empty());
  const auto at_cusp = std::count_if(found.points.begin(), found.points.end(),
                                     [](const CurvePoint& p) { return norm(p.point) < 1e-6; });
  EXPECT_GE(at_cusp, 1);
}

TEST(CurveIntersection, EndsTouchOnOtherCurves) {
  // Bit for bit the same point: proven.
  CurveIntersection found =
      intersect(bezier({{0, 0, 0}, {1, 1, 0}}), bezier({{1, 1, 0}, {2, 0, 0}}));
  EXPECT_EQ(found.status, Status::Complete);
  ASSERT_EQ(found.points.size(), 1U);
  EXPECT_EQ(found.points[0].a, 1);
  EXPECT_EQ(found.points[0].b, 0);
  // Straight on.
  found = intersect(bezier({{0, 0, 0}, {1, 1, 0}}), bezier({{1, 1, 0}, {3, 3, 0}}));
  EXPECT_EQ(found.status, Status::Complete);
  ASSERT_EQ(found.points.size(), 1U);
  EXPECT_TRUE(found.points[0].tangential);
  // An end within tolerance of the middle of the other.
  found = intersect(bezier({{0, 0, 0}, {1, 1, 0}}), bezier({{0.5, 0.5 - 4e-8, 0}, {1, 0, 0}}));
  EXPECT_EQ(found.status, Status::Tolerance);
  ASSERT_EQ(found.points.size(), 1U);
  EXPECT_EQ(found.points[0].b, 0);
  EXPECT_FALSE(found.points[0].tangential);
  ASSERT_EQ(found.places.size(), 1U);
  EXPECT_NEAR(found.places[0].gap_low, 4e-8 * std::sqrt(0.5), 1e-12);
  // And outside of it.
  found = intersect(bezier({{0, 0, 0}, {1, 1, 0}}), bezier({{0.5, 0.5 - 4e-7, 0}, {1, 0, 0}}));
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_TRUE(found.points.empty());
}

// b runs along a line, through the end of a and out of sight, and comes back to it.
TEST(CurveIntersection, EndIsMetOnBothWaysOfACurveThatTurnsBack) {
  const CurveSpans a = bezier({{2, 1, 0}, {-2, 2, 0}, {1, -1, 0}, {0, 1, 0}});
  const CurveSpans b = bezier({{1, 0, 0}, {-1, 2, 0}, {0, 1, 0}});
  for (const bool flat : {true, false}) {
    const CurveIntersection found = flat ? intersect(a, b) : intersect(in_space(a), in_space(b));
    ASSERT_EQ(found.points.size(), 4U);
    EXPECT_NEAR(found.points[2].a, 1, 1e-12);
    EXPECT_NEAR(found.points[3].a, 1, 1e-12);
    EXPECT_NEAR(found.points[2].b + found.points[3].b, 4 / 3.0, 1e-9);
  }
}

// The corner of a polygon that points at a line.
TEST(CurveIntersection, PiecesOfOneLineMeetInTheirCommonEnd) {
  const CurveSpans a = bezier({{0, 0, 0}, {1, 2, 0}});
  for (const CurveSpans& b : {bezier({{1, 2, 0}, {2, 4, 0}}), bezier({{2, 4, 0}, {1, 2, 0}})}) {
    const CurveIntersection found = intersect(a, b);
    EXPECT_TRUE(found.overlaps.empty());
    ASSERT_EQ(found.points.size(), 1u);
    EXPECT_NEAR(found.points[0].a, 1, 1e-7);
    expect_on_both(found, a, b);
  }
  EXPECT_TRUE(intersect(a, bezier({{1.1, 2.2, 0}, {2, 4, 0}})).points.empty());
}

TEST(CurveIntersection, CornerWithinToleranceIsAPoint) {
  const CurveSpans corner = testing::polygon({{-1, 1, 0}, {0, 3e-8, 0}, {1, 1, 0}});
  const CurveIntersection found = intersect(corner, axis());
  EXPECT_EQ(found.status, Status::Tolerance);
  ASSERT_EQ(found.points.size(), 1U);
  EXPECT_EQ(found.points[0].a, 1);
  EXPECT_NEAR(found.places[0].gap_low, 3e-8, 1e-14);
}

TEST(CurveIntersection, CrossingInAJoinOfSpansIsFoundOnce) {
  const CurveSpans bent = testing::polygon({{-1, 0, 0}, {0, 0, 0}, {1, 1, 0}});
  expect_crossings(bent, bezier({{0, -1, 0}, {0, 1, 0}}), 1);
  expect_crossings(bent, testing::polygon({{-1, 1, 0}, {0, 0, 0}, {0.5, -1, 0}}), 1);
}

struct Shared {
  std::string name;
  CurveSpans a, b;
  Interval on_a, on_b;
};

std::vector<Shared> shared_cases() {
  const RationalBezierCurve cubic{{{0, 0, 0, 1}, {1, 3, 0, 1}, {2, -3, 0, 1}, {3, 0, 0, 1}}};
  const CurveSpans whole = curve_spans(cubic);
  const CurveSpans same_law = reparametrised(cubic, {0, 1}, 3.0, 5);
  return {
      {"identical", whole, whole, {0, 1}, {0, 1}},
      {"piece", whole, piece(cubic, {0.3, 1}), {0.3, 1}, {0, 1}},
      {"reversed piece", piece(cubic, {0.8, 0.1}), whole, {0, 1}, {0.8, 0.1}},
      {"two pieces", piece(cubic, {0.2, 0.7}), piece(cubic, {0.5, 0.9}), {0.6, 1}, {0, 0.5}},
      {"elevated, other law", whole, same_law, {0, 1}, {0, 1}},
      {"lines",
       bezier({{0, 0, 0}, {1, 1, 0}}),
       bezier({{0.5, 0.5, 0}, {3, 3, 0}}),
       {0.5, 1},
       {0, 0.2}},
      {"circle and arc", circle({0, 0}, 1), arc({0, 0}, 1, {0.7, 2.9}), {0.7, 2.9}, {0.7, 2.9}}};
}

TEST(CurveIntersection, CommonRunsAreProven) {
  for (const Shared& test : shared_cases())
    for (const bool space : {false, true}) {
      SCOPED_TRACE(test.name + (space ? " in space" : ""));
      const CurveIntersection found =
          intersect(space ? in_space(test.a) : test.a, space ? in_space(test.b) : test.b);
      EXPECT_EQ(found.status, Status::Tolerance);
      EXPECT_TRUE(found.points.empty());
      ASSERT_EQ(found.overlaps.size(), 1U);
      const CurveOverlap& run = found.overlaps[0];
      EXPECT_TRUE(run.proven);
      EXPECT_LE(run.gap_high, 1e-12);
      EXPECT_NEAR(run.a.from, test.on_a.from, 1e-11);
      EXPECT_NEAR(run.a.to, test.on_a.to, 1e-11);
      EXPECT_NEAR(run.b.from, test.on_b.from, 1e-11);
      EXPECT_NEAR(run.b.to, test.on_b.to, 1e-11);
      ASSERT_EQ(found.places.size(), 1U);
      EXPECT_EQ(found.places[0].kind, PlaceKind::Overlap);
    }
}

// Also of one that is a small part of the longer curve.
TEST(CurveIntersection, ShortCurveOnALongOneIsAProvenRun) {
  for (const double length : {1e-2, 1e-4, 1e-6}) {
    const CurveSpans whole = bezier({{0, 0, 0}, {1, 0.5, 0}});
    const CurveSpans part = bezier({{0.5, 0.25, 0}, {0.5 + length, 0.25 + 0.5 * length, 0}});
    for (const auto& [a, b] : {std::pair{whole, part}, std::pair{part, whole}}) {
      const CurveIntersection found = intersect(a, b);
      ASSERT_EQ(found.overlaps.size(), 1u) << length;
      EXPECT_TRUE(found.overlaps[0].proven);
    }
  }
}

TEST(CurveIntersection, CommonRunDoesNotHideOtherCrossings) {
  const RationalBezierCurve loop{{{0, 0, 0, 1}, {3, 2, 0, 1}, {-2, 2, 0, 1}, {1, 0, 0, 1}}};
  const CurveIntersection found = intersect(curve_spans(loop), piece(loop, {0, 0.5}));
  ASSERT_EQ(found.overlaps.size(), 1U);
  ASSERT_EQ(found.points.size(), 1U);  // the node, where the other half of the loop passes
  EXPECT_NEAR(distance(found.points[0].point, {0.5, 0.375, 0}), 0, 1e-12);
  EXPECT_TRUE(found.points[0].proven);
}

// The parabola y = x^2 once more with x = 1.3 t - 0.3 t^2: no linear rational law joins the two, so
// the run is seen, not proven.
TEST(CurveIntersection, CommonRunWithAnotherLawIsSeen) {
  const CurveSpans a = bezier({{0, 0, 0}, {0.5, 0, 0}, {1, 1, 0}});
  const CurveSpans b = curve_spans(bezier_form(
      MonomialCurve{{{0, 0, 0}, {1.3, 0, 0}, {-0.3, 1.69, 0}, {0, -0.78, 0}, {0, 0.09, 0}}}));
  for (const bool space : {false, true}) {
    const CurveIntersection found = intersect(space ? in_space(a) : a, space ? in_space(b) : b);
    EXPECT_EQ(found.status, Status::Tolerance);
    EXPECT_TRUE(found.points.empty());
    ASSERT_EQ(found.overlaps.size(), 1U);
    EXPECT_FALSE(found.overlaps[0].proven);
    EXPECT_LE(found.overlaps[0].gap_high, 1e-12);
    EXPECT_NEAR(found.overlaps[0].a.from, 0, 1e-9);
    EXPECT_NEAR(found.overlaps[0].a.to, 1, 1e-9);
    EXPECT_NEAR(found.overlaps[0].b.from, 0, 1e-9);
    EXPECT_NEAR(found.overlaps[0].b.to, 1, 1e-9);
  }
}

TEST(CurveIntersection, CirclesSideBySideWithinToleranceAreARun) {
  const CurveIntersection found = intersect(circle({0, 0}, 1), circle({0, 0}, 1 + 5e-8));
  EXPECT_EQ(found.status, Status::Tolerance);
  EXPECT_TRUE(found.points.empty());
  ASSERT_EQ(found.overlaps.size(), 1U);
  EXPECT_GE(found.overlaps[0].gap_high, 5e-8);
  EXPECT_LE(found.overlaps[0].gap_high, 1e-7);
}

TEST(CurveIntersection, NearMissesInSpaceAreListedWithTheirGap) {
  const CurveSpans a = bezier({{-1, 0, 0}, {0, 0.5, 0}, {1, 0, 0}});
  for (const double gap : {0.0, 1e-12, 1e-9, 8e-8, 2e-7, 1e-6, 1e-2}) {
    const CurveSpans b = bezier({{0, -1, gap}, {0.1, 0, gap}, {0.2, 1, gap}});
    const CurveIntersection found = intersect(a, b);
    if (gap > 1e-7) {
      EXPECT_EQ(found.status, Status::Complete);
      EXPECT_TRUE(found.points.empty());
    } else {
      ASSERT_EQ(found.points.size(), 1U) << gap;
      EXPECT_EQ(found.points[0].proven, gap == 0);
      EXPECT_EQ(found.status, gap == 0 ? Status::Complete : Status::Tolerance);
      if (gap > 0) {
        EXPECT_NEAR(found.places[0].gap_low, gap, 1e-13);
        EXPECT_NEAR(found.places[0].gap_high, gap, 1e-13);
      }
    }
  }
}

TEST(CurveIntersection, HighDegreesAndUnevenWeightsAreRight) {
  // Chebyshev's polynomial of degree 25 has the Bernstein coefficients
  // (-1)^(n - i) binom(2n, 2i) / binom(n, i); rounding them leaves its 25 changes of sign.
  BezierCurve wave;
  double ratio = -1.0 / 4096;
  for (int i = 0; i <= 25; ++i) {
    wave.points.push_back({i / 25.0, ratio, 0});
    ratio *=
        -(50.0 - 2 * i) * (49.0 - 2 * i) / ((2 * i + 1.0) * (2 * i + 2.0)) * (i + 1.0) / (25.0 - i);
  }
  expect_crossings(curve_spans(wave), bezier({{-0.1, 0, 0}, {1.1, 0, 0}}), 25);
  // Alternating points: y = (1 - 2x)^25, a contact of order 25.
  for (std::size_t i = 0; i <= 25; ++i) wave.points[i][1] = i % 2 ? -1.0 : 1.0;
  const CurveIntersection found = intersect(curve_spans(wave), bezier({{-0.1, 0, 0}, {1.1, 0, 0}}));
  EXPECT_EQ(found.status, Status::Tolerance);
  EXPECT_EQ(found.places.size(), 1U);
  // Weights of ratio 1000 pull the curve to its middle points.
  RationalBezierCurve pulled;
  for (int i = 0; i <= 5; ++i) {
    const double w = i % 2 ? 1000 : 1;
    pulled.points.push_back({w * i, w * (i % 2 ? -1.0 : 1.0) * (i < 3 ? 1 : -1), 0, w});
  }
  std::vector<testing::Rational> height;
  for (const Vec4& p : pulled.points) height.emplace_back(p[1]);
  expect_crossings(curve_spans(pulled), bezier({{-1, 0, 0}, {6, 0, 0}}),
                   static_cast<std::size_t>(testing::count_roots(testing::powers(height), 0, 1)));
}

TEST(CurveIntersection, FarFromTheOriginDigitsAreKept) {
  CurveSpans a = parabola(-1e-6), b = axis();
  for (CurveSpans* curve : {&a, &b})
    for (Vec4& p : curve->spans[0].curve.points) p += Vec4{1024, -4096, 0, 0};
  EXPECT_EQ(intersect(a, b).points.size(), 2U);
}

TEST(CurveIntersection, BudgetCancelAndTimeStopWithOpenPlaces) {
  IntersectionOptions options;
  options.budget = 3;
  CurveIntersection found = intersect(circle({0, 0}, 1), circle({0.5, 0.3}, 1), options);
  EXPECT_EQ(found.status, Status::Stopped);
  EXPECT_FALSE(found.places.empty());
  EXPECT_EQ(found.places.back().kind, PlaceKind::Open);
}

TEST(CurveIntersection, RefusesBadInput) {
  IntersectionOptions options;
  options.tolerances.point = 0;
  EXPECT_THROW(intersect(axis(), axis(), options), InvalidInput);
  EXPECT_THROW(intersect({}, axis()), InvalidInput);
  EXPECT_THROW(intersect(axis(), bezier({{0, 0, 0}})), InvalidInput);
  EXPECT_THROW(intersect(axis(), bezier({{0, std::nan(""), 0}, {1, 1, 1}})), InvalidInput);
  CurveSpans negative = circle({0, 0}, 1);
  negative.spans[1].curve.points[1][3] = -0.1;
  EXPECT_THROW(intersect(axis(), negative), InvalidInput);
}

// A curve cut into spans is the same curve: same points, and one common run from end to end.
TEST(CurveIntersection, CutsIntoSpansChangeNothing) {
  auto random = seeded(3);
  for (int trial = 0; trial < 200; ++trial) {
    const int n = testing::pick(random, 2, 6);
    const auto whole = testing::random_curve<Vec4>(random, n);
    RationalBezierCurve a;
    for (const Vec4& p : whole.points) a.points.push_back({p[0], p[1], 0, 1});
    const double first = testing::uniform(random, 0.1, 0.5);
    const std::vector<double> cuts{0, first, testing::uniform(random, first + 0.1, 0.9), 1};
    CurveSpans spans;
    for (std::size_t i = 0; i < 3; ++i) {
      CurveSpan span = piece(a, {cuts[i], cuts[i + 1]}).spans[0];
      span.place = {cuts[i], cuts[i + 1]};
      spans.spans.push_back(span);
    }
    const CurveIntersection found = intersect(curve_spans(a), spans);
    ASSERT_EQ(found.overlaps.size(), 1U) << trial;
    EXPECT_EQ(found.overlaps[0].a, (Interval{0, 1})) << trial;
    EXPECT_EQ(self_intersections(curve_spans(a)).points.size(),
              self_intersections(spans).points.size())
        << trial;
  }
}

}  // namespace
}  // namespace blossom
