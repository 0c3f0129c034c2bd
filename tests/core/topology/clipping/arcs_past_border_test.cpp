// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/topology/clipping/arcs_past_border.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "core/results/hermite_curves.h"
#include "core/topology/clipping/clipped_result.h"
#include "tests/support/flat_trims.h"

namespace blossom {
namespace {

using std::numbers::pi;

Vec3 on_tube(const Vec2& uv) { return {std::cos(uv[0]), std::sin(uv[0]), uv[1]}; }

// A tube of radius 1 and height 3, its seam at u = 0.
FaceTrims tube() {
  testing::FlatLoops loops;
  loops.add_polygon({{0, 0}, {2 * pi, 0}, {2 * pi, 3}, {0, 3}});
  SurfaceChart chart = testing::plane_chart();
  chart.period = {2 * pi, 0};
  chart.jet = [](const Vec2& uv) {
    return SurfaceJet{on_tube(uv), {-std::sin(uv[0]), std::cos(uv[0]), 0}, {0, 0, 1}};
  };
  return trims_of(chart, std::move(loops.vertices), std::move(loops.loops)).value();
}

// A curve that reaches its largest u at v = 1.5, `past` beyond the seam, as far as it lies on one
// side of that.
IntersectionCurve part(double past, const Interval& v, bool beyond) {
  std::vector<HermiteJet> jets;
  constexpr int kSteps = 64;
  for (int i = 0; i <= kSteps; ++i) {
    const double t = at(v, static_cast<double>(i) / kSteps), off = t - 1.5;
    const Vec2 uv{past - 0.1 * off * off + (beyond ? 0 : 2 * pi), t}, rate{-0.2 * off, 1};
    const Vec3 along{-std::sin(uv[0]) * rate[0], std::cos(uv[0]) * rate[0], 1};
    jets.push_back({{on_tube(uv), uv, uv}, {along, rate, rate}});
  }
  IntersectionCurve curve = hermite_curve(jets, v);
  curve.length = length(v);
  curve.ends = {CurveEnd::BorderA, CurveEnd::BorderA};
  return curve;
}

// In three: before the seam, on its other side, and before it again. Rounding takes the ends of the
// arc between them along the seam.
SurfaceIntersection touching(double past, double rounding) {
  const double half = std::sqrt(10 * past);
  SurfaceIntersection found;
  found.curves = {part(past, {0.5, 1.5 - half}, false),
                  part(past, {1.5 - (1 - rounding) * half, 1.5 + (1 - rounding) * half}, true),
                  part(past, {1.5 + half, 2.5}, false)};
  return found;
}

TEST(ArcsPastBorder, OfACurveThatTouchesASeamBelongToItsNeighbours) {
  const FaceTrims trims = tube();
  for (const double past : {1e-12, 1e-10, 5e-8})
    for (const double rounding : {0.0, 0.2}) {
      SurfaceIntersection found = touching(past, rounding);
      const auto touches = clip(found, trims, nullptr);
      EXPECT_TRUE(touches.empty());
      ASSERT_EQ(found.curves.size(), 2u);
      const IntersectionCurve &first = found.curves[0], &second = found.curves[1];
      EXPECT_LT(distance(first.samples.back().point, second.samples.front().point), 1e-12);
      EXPECT_LT(distance(first.samples.back().uv_a, second.samples.front().uv_a), 1e-9);
      EXPECT_NEAR(first.length + second.length, 2, 1e-6);
      for (const IntersectionCurve& curve : found.curves) {
        EXPECT_LT(curve.deviation.a, 1e-7);
        const Vec3 last = point_at(curve.curve, curve.curve.domain().to);
        EXPECT_LT(distance(last, curve.samples.back().point), 1e-12);
        EXPECT_LT(distance(last, on_tube(point_at(curve.chart_a, curve.curve.domain().to))), 1e-9);
      }
    }
}

TEST(ArcsPastBorder, WithoutANeighbourAreTouches) {
  SurfaceIntersection found;
  found.curves = {part(1e-10, {1.5 - 3e-5, 1.5 + 3e-5}, true)};
  EXPECT_EQ(clip(found, tube(), nullptr).size(), 1u);
  EXPECT_TRUE(found.curves.empty());
}

TEST(ArcsPastBorder, AreNoneThatLeaveTheSeamByMoreThanTouchesDo) {
  SurfaceIntersection found = touching(1e-4, 0);
  EXPECT_TRUE(clip(found, tube(), nullptr).empty());
  EXPECT_EQ(found.curves.size(), 3u);
}

}  // namespace
}  // namespace blossom
