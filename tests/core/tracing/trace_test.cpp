// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tracing/trace.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/surfaces/search/pair_search.h"
#include "core/tracing/fit.h"
#include "tests/support/cubic_family.h"

namespace blossom {
namespace {

// A traced loop, with all that the tracer refers to.
class TracedLoop : public ::testing::Test {
 protected:
  testing::CubicPair pair_ = testing::cubic_pair(testing::loop(0.43, 0.57, 0.2));
  SurfaceCells a_{pair_.a, {0.5, 0.5, 0}, CellForm::Auto, 0.4865};
  SurfaceCells b_{pair_.b, {0.5, 0.5, 0}, CellForm::Auto, 0.4865};
  PairSearchResult found_ = search_pairs(a_, b_, {{0, 0, 0, 0}}, 1, KnownCurves({}, {}), {});
  std::vector<CriticalCluster> clusters_;
  std::vector<Chain> chains_ = chains_of(found_, a_, b_, {}, clusters_);
};

TEST_F(TracedLoop, IsOneClosedChain) {
  ASSERT_EQ(chains_.size(), 1u);
  EXPECT_TRUE(chains_[0].closed);
  EXPECT_TRUE(found_.critical.empty());
}

TEST_F(TracedLoop, DerivativesAreThoseOfTheCurve) {
  const ChainTracer tracer(found_, a_, b_, {0.5, 0.5, 0}, chains_.at(0));
  const double total = tracer.stations().back();
  for (int i = 1; i < 40; ++i) {
    const double station = total * i / 40;
    const double step = 1e-4 * total;
    const TracePoint p = tracer.at(station, true);
    const TracePoint before = tracer.at(station - step, true);
    const TracePoint after = tracer.at(station + step, true);
    // Central differences over arc length; their error is of second order in the step.
    const double forth = distance(after.point, p.point), back = distance(p.point, before.point);
    const Vec3 first = (after.point - before.point) * (1 / (forth + back));
    EXPECT_LE(distance(first, p.first), 1e-4);
    EXPECT_LE(distance((after.first - before.first) * (1 / (forth + back)), p.second), 2e-2);
    EXPECT_LE(distance((after.a - before.a) * (1 / (forth + back)), p.a_first), 1e-3);
    EXPECT_LE(distance((after.b_first - before.b_first) * (1 / (forth + back)), p.b_second), 2e-2);
    EXPECT_NEAR(norm(p.first), 1, 1e-14);
    EXPECT_NEAR(dot(p.first, p.second), 0, 1e-10);
  }
}

TEST_F(TracedLoop, APointBesideTheCurveLeadsOntoIt) {
  const ChainTracer tracer(found_, a_, b_, {0.5, 0.5, 0}, chains_.at(0));
  const double total = tracer.stations().back();
  for (int i = 0; i < 40; ++i) {
    const double station = total * (i + 0.5) / 40;
    const TracePoint p = tracer.at(station, true);
    const SurfacePoint start{p.point + Vec3{3e-5, -2e-5, 1e-5}, p.a + Vec2{1e-5, 2e-5},
                             p.b + Vec2{-2e-5, 1e-5}};
    const auto found = tracer.beside(station, start, 1e-8);
    ASSERT_TRUE(found);
    const auto& [x, a, b] = found->point;
    EXPECT_LE(distance(x, point_at(pair_.a, a)), 1e-14);
    EXPECT_LE(distance(x, point_at(pair_.b, b)), 1e-14);
    EXPECT_NEAR(dot(x - start.point, p.first), 0, 1e-8);
    EXPECT_NEAR(found->sine, p.sine, 1e-4);
    EXPECT_FALSE(tracer.beside(station, {start.point, start.uv_a, {0.1, 0.9}}, 1e-8));
  }
}

TEST_F(TracedLoop, KnownPointsAreInOrderAlongTheLoop) {
  const ChainTracer tracer(found_, a_, b_, {0.5, 0.5, 0}, chains_.at(0));
  ASSERT_EQ(tracer.known_points().size(), 2 * chains_[0].links.size() - 1);
  double turn = 0, last = 0;
  for (const Vec3& x : tracer.known_points()) {
    EXPECT_NEAR(std::hypot(x[0] - 0.43, x[1] - 0.57), 0.2, 1e-12);
    const double angle = std::atan2(x[1] - 0.57, x[0] - 0.43);
    if (&x != &tracer.known_points().front())
      turn += std::remainder(angle - last, 2 * std::numbers::pi);
    last = angle;
  }
  EXPECT_GT(std::abs(turn), 0.8 * 2 * std::numbers::pi);
  EXPECT_LT(std::abs(turn), 2 * std::numbers::pi);
}

TEST_F(TracedLoop, LinksMeetInPositionTangentAndCurvature) {
  const ChainTracer tracer(found_, a_, b_, {0.5, 0.5, 0}, chains_.at(0));
  const auto& stations = tracer.stations();
  for (std::size_t i = 1; i + 1 < stations.size(); ++i) {
    const TracePoint before = tracer.at(stations[i], false), after = tracer.at(stations[i], true);
    EXPECT_LE(distance(before.point, after.point), 1e-11);
    EXPECT_LE(distance(before.first, after.first), 1e-9);
    EXPECT_LE(distance(before.second, after.second), 1e-6);
  }
}

TEST_F(TracedLoop, NoFitIsReturnedThatStraysOrIsLate) {
  const ChainTracer tracer(found_, a_, b_, {0.5, 0.5, 0}, chains_.at(0));
  IntersectionOptions options;
  options.time_limit = 1e-9;
  const WorkLimit late(options);

  EXPECT_TRUE(std::isnan(fitted(tracer, pair_.a, pair_.b, {.most = 1e-30}).length));
  EXPECT_TRUE(std::isnan(fitted(tracer, pair_.a, pair_.b, {.work = &late}).length));
  EXPECT_FALSE(std::isnan(fitted(tracer, pair_.a, pair_.b, {.most = 1e-6}).length));
}

TEST_F(TracedLoop, TheFitHoldsWhatItWasAskedFor) {
  const ChainTracer tracer(found_, a_, b_, {0.5, 0.5, 0}, chains_.at(0));
  std::size_t last_poles = 0;
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
    const IntersectionCurve curve =
        fitted(tracer, pair_.a, pair_.b, {.tolerance = tolerance, .size = 1});
    EXPECT_LE(curve.deviation.a, tolerance);
    EXPECT_LE(curve.deviation.b, tolerance);
    EXPECT_LE(curve.deviation.between, tolerance);
    EXPECT_GE(curve.curve.points.size(), last_poles);
    EXPECT_EQ(curve.curve.points.size(), curve.chart_a.points.size());
    last_poles = curve.curve.points.size();
    // Off the surfaces' own agreement, the loop itself: (x - 0.43)^2 + (y - 0.57)^2 = 0.04.
    for (int i = 0; i <= 300; ++i) {
      const Vec3 x = point_at(curve.curve, at(curve.curve.domain(), i / 300.0));
      EXPECT_NEAR(std::hypot(x[0] - 0.43, x[1] - 0.57), 0.2, 10 * tolerance + 1e-13);
    }
  }
}

}  // namespace
}  // namespace blossom
