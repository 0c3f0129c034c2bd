// SPDX-License-Identifier: LGPL-2.1-or-later
// A straight cell and a bent one: all from the polynomial of the distance, without cutting.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "core/curve_intersection.h"
#include "core/curves/curve_valley.h"
#include "tests/support/curves.h"
#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::bezier;
using testing::seeded;
using testing::uniform;

constexpr double kLineTolerance = 1e-7;

// The graph of bend (x - p) (x - q) over [0, 1].
CurveSpans parabola(double p, double q, double bend) {
  const auto value = [&](double x) { return bend * (x - p) * (x - q); };
  return bezier({{0, value(0), 0}, {0.5, bend * (p * q - 0.5 * (p + q)), 0}, {1, value(1), 0}});
}

std::optional<ValleyPoints> points(const CurveSpans& a, const CurveSpans& b) {
  CurveTree tree_a(a, Vec3{}, 2), tree_b(b, Vec3{}, 2);
  tree_a.direct(0);
  tree_b.direct(0);
  return line_points({tree_a, tree_a[0], tree_b, tree_b[0]}, kLineTolerance, 0.03);
}

TEST(LinePoints, TwoZerosOfAParabolaAreFoundFromTheWholeCurves) {
  auto random = seeded(1);
  for (int trial = 0; trial < 500; ++trial) {
    const double p = uniform(random, 0.02, 0.45), q = uniform(random, 0.55, 0.98);
    const CurveSpans curve = parabola(p, q, trial % 2 == 0 ? 2 : -0.3);
    const CurveSpans line = bezier({{-1, 0, 0}, {3, 0, 0}});
    const auto found = trial % 3 == 0 ? points(curve, line) : points(line, curve);
    ASSERT_TRUE(found);
    ASSERT_EQ(found->count, 2);
    std::array<double, 2> at;
    for (std::size_t i = 0; i < 2; ++i) {
      const CurveFoot& foot = found->points[i].foot;
      EXPECT_FALSE(found->points[i].touch);
      EXPECT_LE(norm(foot.gap()), 1e-15);
      at[i] = foot.jet_a.point[0];
    }
    EXPECT_NEAR(std::min(at[0], at[1]), p, 1e-13);
    EXPECT_NEAR(std::max(at[0], at[1]), q, 1e-13);
  }
}

TEST(LinePoints, LineThatEndsBetweenTheZerosHoldsOne) {
  const auto found = points(parabola(0.25, 0.75, 1), bezier({{0.5, 0, 0}, {2, 0, 0}}));
  ASSERT_TRUE(found);
  ASSERT_EQ(found->count, 1);
  EXPECT_NEAR(found->points[0].foot.b.t, 1.0 / 6, 1e-14);
}

TEST(LinePoints, TouchHasItsGap) {
  for (const double gap : {0.0, 1e-9, 5e-8}) {
    CurveSpans curve = parabola(0.375, 0.375, 1);
    for (Vec4& p : curve.spans[0].curve.points) p[1] += gap;
    const auto found = points(bezier({{-0.5, 0, 0}, {1.5, 0, 0}}), curve);
    ASSERT_TRUE(found);
    ASSERT_EQ(found->count, 1);
    EXPECT_TRUE(found->points[0].touch);
    EXPECT_LE(found->points[0].gap.low, gap);
    EXPECT_GE(found->points[0].gap.high, gap);
    EXPECT_NEAR(found->points[0].foot.b.t, 0.375, 1e-8);
  }
}

TEST(LinePoints, MonotoneDistanceHasOneZero) {
  // The graph of (x - 1/2)^3 + (x - 1/2) + 1/4, bent both ways.
  const auto found = points(bezier({{0, -0.375, 0},
                                    {1.0 / 3, 0.25 - 1.0 / 24, 0},
                                    {2.0 / 3, 0.25 + 1.0 / 24, 0},
                                    {1, 0.875, 0}}),
                            bezier({{-2, 0, 0}, {2, 0, 0}}));
  ASSERT_TRUE(found);
  ASSERT_EQ(found->count, 1);
  const double x = found->points[0].foot.a.t - 0.5;
  EXPECT_NEAR(x * x * x + x + 0.25, 0, 1e-15);
}

TEST(LinePoints, WhatRunsAlongALineIsLeftToOthers) {
  EXPECT_FALSE(points(parabola(0, 1, 1e-9), bezier({{0, 0, 0}, {1, 0, 0}})));
  EXPECT_FALSE(points(bezier({{0, 0, 0}, {1, 1, 0}}), bezier({{0, 1, 0}, {1, 0, 0}})));
}

TEST(LinePoints, CommonEndOfALineAndACurveIsProven) {
  const CurveSpans curve = bezier({{0, 0, 0}, {0.3, 0.9, 0}, {0.8, -0.7, 0}, {1, 0.1, 0}});
  const CurveIntersection found = intersect(bezier({{0, 0, 0}, {0.9, -0.4, 0}}), curve);
  EXPECT_EQ(found.status, Status::Complete);
  ASSERT_FALSE(found.points.empty());
  EXPECT_EQ(found.points[0].a, 0);
  EXPECT_EQ(found.points[0].b, 0);
}

// The line ends 50 tolerances before the place where it would graze the curve. There it is
// as near to the curve beside it.
TEST(LinePoints, FootIsNotTakenBeyondTheEndOfALine) {
  const CurveSpans curve = parabola(0.5, 0.5, 1e-3);
  const CurveSpans line = bezier({{-0.400005, 0, 0}, {0.499995, 0, 0}});
  for (const bool swapped : {false, true}) {
    const CurveIntersection found = swapped ? intersect(line, curve) : intersect(curve, line);
    ASSERT_EQ(found.points.size(), 1U);
    const CurvePoint& at = found.points.front();
    const double on_curve = swapped ? at.b : at.a, on_line = swapped ? at.a : at.b;
    EXPECT_LE(distance(point_at(curve, on_curve), point_at(line, on_line)), kLineTolerance);
  }
}

TEST(LinePoints, CuspIsNotCutUp) {
  const CurveSpans cusp = bezier({{-1, 1, 0}, {1, -1, 0}, {-1, -1, 0}, {1, 1, 0}});
  const double x = 0.01;
  const CurveIntersection found = intersect(cusp, bezier({{-1, x - 0.3, 0}, {1, x + 0.3, 0}}));
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_LE(found.certificate.depth, 6);
}

TEST(LinePoints, RandomLinesMeetWhatExactSignsTell) {
  auto random = seeded(5);
  const auto turn = [](const Vec3& a, const Vec3& b) { return a[0] * b[1] - a[1] * b[0]; };
  for (int trial = 0; trial < 400; ++trial) {
    std::vector<Vec3> net;
    for (int i = 0; i <= 2 + trial % 4; ++i)
      net.push_back({uniform(random, -1, 1), uniform(random, -1, 1), 0});
    const CurveSpans curve = bezier(net);
    const Vec3 p{uniform(random, -1, 1), uniform(random, -1, 1), 0},
        q{uniform(random, -1, 1), uniform(random, -1, 1), 0};
    // Changes of side between samples, over the line's length.
    int least = 0;
    constexpr int kSamples = 2000;
    for (int k = 0; k < kSamples; ++k) {
      const Vec3 x = point_at(curve, static_cast<double>(k) / kSamples) - p;
      const Vec3 y = point_at(curve, (k + 1.0) / kSamples) - p;
      const double s = dot(x + y, q - p) / (2 * dot(q - p, q - p));
      least += turn(q - p, x) * turn(q - p, y) < 0 && s > 0.01 && s < 0.99;
    }
    const CurveIntersection found = intersect(curve, bezier({p, q}));
    EXPECT_GE(static_cast<int>(found.points.size()), least) << trial;
    EXPECT_LE(static_cast<int>(found.points.size()), 2 + trial % 4) << trial;
    for (const CurvePoint& point : found.points)
      EXPECT_LE(distance(point_at(curve, point.a), p + (q - p) * point.b), kLineTolerance + 1e-12);
  }
}

}  // namespace
}  // namespace blossom
