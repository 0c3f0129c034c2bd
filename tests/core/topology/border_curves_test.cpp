// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/topology/border_curves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/forms/evaluation.h"
#include "tests/support/cubic_family.h"
#include "tests/support/quadric_patches.h"
#include "tests/support/surface_changes.h"

namespace blossom {
namespace {

FaceTrims with_border(const PlanarBezier& curve, const Vec2& scale = {1, 1}) {
  Coedge coedge;
  coedge.curve.spans.push_back({curve, {0, 1}});
  FaceTrims trims;
  trims.scale = scale;
  trims.loops = {{coedge}};
  return trims;
}

Vec3 on(const RationalBezierCurve& curve, double t) { return jet_at(curve, t).point; }

double length_of(const std::vector<RationalBezierCurve>& curves) {
  double sum = 0;
  for (const RationalBezierCurve& curve : curves)
    for (int i = 0; i < 64; ++i) sum += distance(on(curve, i / 64.0), on(curve, (i + 1) / 64.0));
  return sum;
}

TEST(BorderCurves, LieOnTheSurfaceAndAreCutAtItsKnots) {
  const BezierSurface surface =
      testing::split_in_u(testing::graph(testing::base_cubic(), {0, 0}, {1, 0}, {0, 1}), 0.4);
  // u from 2 to 5, twice as long in the chart; over the knot.
  const PlanarBezier curve{{{4.4, 0.1, 1}, {6, 0.9, 1}, {9.8, 0.5, 1}}};
  const auto found = border_curves(with_border(curve, {2, 1}), surface);
  ASSERT_TRUE(found);
  ASSERT_GE(found->size(), 2u);
  EXPECT_LE(distance(on(found->front(), 0), point_at(surface, {2.2, 0.1})), 1e-12);
  EXPECT_LE(distance(on(found->back(), 1), point_at(surface, {4.9, 0.5})), 1e-12);
  const testing::Cubic height = testing::base_cubic();
  for (std::size_t i = 0; i < found->size(); ++i) {
    if (i > 0) {
      EXPECT_LE(distance(on((*found)[i - 1], 1), on((*found)[i], 0)), 1e-9);
    }
    for (const double t : {0.0, 0.3, 0.8}) {
      const Vec3 p = on((*found)[i], t);
      EXPECT_NEAR(p[2], height(p[0], p[1]), 1e-12);
    }
  }
}

// A helix of pitch 1 on a quarter of a cylinder, and the same with a rational curve.
TEST(BorderCurves, RunAlongAngles) {
  BezierSurface surface = testing::of_patch(testing::cylinder_quarter(2, 1));
  constexpr double quarter = 0.5 * std::numbers::pi;
  surface.u_law = ParameterLaw::Angle;
  surface.u_knots = {0, quarter};
  const auto found = border_curves(with_border({{{0, 0, 1}, {quarter, 1, 1}}}), surface);
  ASSERT_TRUE(found);
  EXPECT_NEAR(length_of(*found), std::hypot(2 * quarter, 1), 1e-4);
  for (const RationalBezierCurve& curve : *found) {
    const Vec3 p = on(curve, 0.37);
    EXPECT_NEAR(std::hypot(p[0], p[1]), 2, 1e-11);
    EXPECT_NEAR(std::atan2(p[1], p[0]), quarter * p[2], 1e-11);
  }
  EXPECT_FALSE(border_curves(with_border({{{0, 0, 1}, {1, 0.5, 2}, {1, 1, 1}}}), surface));
}

TEST(BorderCurves, OfHighDegreesAreReduced) {
  const BezierSurface surface = testing::graph(testing::base_cubic(), {0, 0}, {1, 0}, {0, 1});
  PlanarBezier curve;  // degree 12 on a bicubic patch: 72
  for (int i = 0; i <= 12; ++i) curve.points.push_back({i / 12.0, 0.5 + 0.2 * std::sin(i), 1});
  const auto found = border_curves(with_border(curve), surface);
  ASSERT_TRUE(found);
  for (const RationalBezierCurve& each : *found) EXPECT_LE(each.degree(), kMaxDegree);
  EXPECT_LE(distance(on(found->back(), 1), point_at(surface, {1, curve.points[12][1]})), 1e-11);
}

}  // namespace
}  // namespace blossom
