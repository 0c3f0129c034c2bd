// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tessellation/edge_polyline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/errors.h"
#include "tests/support/random.h"
#include "tests/support/solids.h"

namespace blossom {
namespace {

using testing::seeded;
using testing::uniform;

constexpr int kPolylineSamples = 4000;

// A circle of radius 1 in four arcs, by the angle.
CurveSpans circle() {
  CurveSpans curve;
  curve.rational = true;
  for (int k = 0; k < 4; ++k) {
    const double from = k * std::numbers::pi / 2;
    CurveSpan span;
    for (const Vec3& p : testing::quarter_arc(from)) {
      // The middle point of an arc is its direction over the weight; all are homogeneous here.
      span.curve.points.push_back({p[0], p[1], 0, p[2]});
    }
    span.place = {from, from + std::numbers::pi / 2};
    span.law = ParameterLaw::Angle;
    curve.spans.push_back(span);
  }
  return curve;
}

double gap(const EdgePolyline& line, const Vec3& p) {
  double least = 1e300;
  for (std::size_t k = 0; k + 1 < line.points().size(); ++k) {
    const Vec3 &a = line.points()[k], d = line.points()[k + 1] - a;
    const double t = std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0);
    least = std::min(least, distance(p, a + t * d));
  }
  return least;
}

double sampled(const CurveSpans& curve, const EdgePolyline& line) {
  double most = 0;
  for (int k = 0; k <= kPolylineSamples; ++k)
    most = std::max(
        most,
        gap(line, point_at(curve, at(curve.domain(), static_cast<double>(k) / kPolylineSamples))));
  return most;
}

TEST(EdgePolyline, OfACircleIsARegularPolygonOfTheFewestSides) {
  const EdgePolyline line(circle(), true, {.deviation = 0.01, .angle = 0});

  // 1 - cos(pi / n) <= 0.85 * 0.01
  const double aimed = std::numbers::pi / std::acos(1 - 0.0085);
  EXPECT_EQ(line.segments(), static_cast<std::size_t>(std::ceil(aimed)));
  const double side = distance(line.points()[0], line.points()[1]);
  for (std::size_t k = 0; k < line.segments(); ++k)
    EXPECT_NEAR(distance(line.points()[k], line.points()[k + 1]), side, 2e-3 * side);
  EXPECT_LE(sampled(circle(), line), line.distance());
  EXPECT_LE(line.distance(), 0.01);
}

TEST(EdgePolyline, OfAClosedEdgeHasThreeSegmentsHoweverCoarse) {
  EXPECT_EQ(EdgePolyline(circle(), true, {.deviation = 100, .angle = 0}).segments(), 3u);
}

TEST(EdgePolyline, TurnsByNoMoreThanTheAngle) {
  EXPECT_EQ(EdgePolyline(circle(), true, {.deviation = 100, .angle = 0.5}).segments(), 13u);
}

TEST(EdgePolyline, HasSidesOfTheWantedLength) {
  const CurveSpans line = curve_spans(BezierCurve{{{0, 0, 0}, {10, 0, 0}}});
  EXPECT_EQ(EdgePolyline(line, false, {.deviation = 1, .edge_length = 0.5}).segments(), 20u);
  EXPECT_EQ(EdgePolyline(line, false, {.deviation = 1e-9}).segments(), 1u);
}

TEST(EdgePolyline, OfMoreSidesThanMemoryHoldsIsRefused) {
  EXPECT_THROW(EdgePolyline(circle(), true, {.deviation = 1e-14}), InvalidInput);
  EXPECT_THROW(EdgePolyline(circle(), true, {.deviation = 1e-3, .edge_length = 1e-12}),
               InvalidInput);
}

TEST(EdgePolyline, HasAPointAtACorner) {
  CurveSpans curve;
  curve.spans.push_back({{{{0, 0, 0, 1}, {1, 0, 0, 1}}}, {0, 1}});
  curve.spans.push_back({{{{1, 0, 0, 1}, {1, 0.05, 0, 1}}}, {1, 2}});
  const EdgePolyline line(curve, false, {.deviation = 1});
  ASSERT_EQ(line.segments(), 2u);
  EXPECT_EQ(line.points()[1], (Vec3{1, 0, 0}));
}

TEST(EdgePolyline, IsWithinItsBoundOfRandomCurves) {
  auto random = seeded(3);
  for (int trial = 0; trial < 40; ++trial) {
    BezierCurve bezier;
    for (int k = 0; k < 6; ++k)
      bezier.points.push_back(
          {uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)});
    const CurveSpans curve = curve_spans(bezier);
    const EdgePolyline line(curve, false, {.deviation = 1e-3});
    const double gap = sampled(curve, line);
    EXPECT_LE(gap, line.distance());
    EXPECT_LE(line.distance(), 1e-3);
    EXPECT_LE(line.distance(), 3 * gap);
  }
}

TEST(EdgePolyline, HalvesTheSegmentsThatItIsTold) {
  EdgePolyline line(curve_spans(BezierCurve{{{0, 0, 0}, {8, 0, 0}}}), false,
                    {.deviation = 1, .edge_length = 4});
  ASSERT_EQ(line.segments(), 2u);
  line.split({1});
  ASSERT_EQ(line.segments(), 3u);
  EXPECT_EQ(line.points()[1], (Vec3{4, 0, 0}));
  EXPECT_EQ(line.points()[2], (Vec3{6, 0, 0}));
}

// Of the deviation their bound is a small part, too.
TEST(EdgePolyline, IsProvenAsNearAsItsAngleOrLengthMakesIt) {
  for (const FacetOptions& options :
       {FacetOptions{.deviation = 1, .angle = 0.1},
        FacetOptions{.deviation = 1, .angle = 0, .edge_length = 0.1}}) {
    const EdgePolyline line(circle(), true, options);
    const double gap = sampled(circle(), line);
    EXPECT_LE(gap, line.distance());
    EXPECT_LE(line.distance(), 1.2 * gap);
  }
}

// Chords over halves of a curve that swings are farther from it than the one over the whole.
TEST(EdgePolyline, StaysWithinItsBoundWhenItIsSplit) {
  const CurveSpans swing =
      curve_spans(BezierCurve{{{0, 0, 0}, {20, 9, 0}, {40, -9, 0}, {60, -1, 0}, {80, 0, 0}}});
  EdgePolyline line(swing, false, {.deviation = 20, .angle = 0});
  ASSERT_EQ(line.segments(), 1u);
  const double whole = sampled(swing, line);

  line.split({0});

  EXPECT_GT(sampled(swing, line), whole);
  EXPECT_LE(sampled(swing, line), line.distance());
}

}  // namespace
}  // namespace blossom
