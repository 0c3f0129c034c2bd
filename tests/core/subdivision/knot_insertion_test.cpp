// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/subdivision/knot_insertion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "core/base/errors.h"
#include "tests/support/random.h"
#include "tests/support/surface_changes.h"

namespace blossom {
namespace {

using std::numbers::pi;

BezierSurface cubic() {
  testing::Random random = testing::seeded(5);
  RationalBezierPatch patch{Grid<Vec4>(4, 3)};
  for (Vec4& p : patch.points.values())
    p = {testing::uniform(random, -1, 1), testing::uniform(random, -1, 1),
         testing::uniform(random, -1, 1), 1};
  return testing::of_patch(patch);
}

// Two thirds of a turn of a cylinder of radius 3 and height 7.
BezierSurface tube() {
  const double span = pi / 3, w = std::cos(span / 2);
  BezierSurface surface{{0, span, 2 * span}, {0, 7}, ParameterLaw::Angle};
  surface.rational = true;
  surface.patches = Grid<RationalBezierPatch>(2, 1);
  for (int i = 0; i < 2; ++i) {
    Grid<Vec4> net(3, 2);
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 2; ++j) {
        const double angle = (i + 0.5 * k) * span, weight = k == 1 ? w : 1;
        net(k, j) = {3 * std::cos(angle), 3 * std::sin(angle), weight * 7 * j, weight};
      }
    surface.patches(i, 0).points = net;
  }
  return surface;
}

void expect_same_points(const BezierSurface& a, const BezierSurface& b) {
  for (double s = 0.5 / 16; s < 1; s += 1.0 / 16)
    for (double t = 0; t <= 1; t += 0.25) {
      const Vec2 uv{at({a.u_knots.front(), a.u_knots.back()}, s),
                    at({a.v_knots.front(), a.v_knots.back()}, t)};
      EXPECT_LE(distance(point_at(a, uv), point_at(b, uv)), 4e-15);
    }
}

TEST(KnotInsertion, KeepsPointsAndTheirParameters) {
  const BezierSurface in_v = with_knot(cubic(), Direction::V, 0.4);
  EXPECT_EQ(in_v.v_knots, (std::vector<double>{0, 0.4, 1}));
  expect_same_points(cubic(), in_v);
  expect_same_points(cubic(), with_knot(in_v, Direction::U, 0.7));
  for (const double angle : {0.1, 1.0, 1.5, 2.0}) {
    const BezierSurface cut = with_knot(tube(), Direction::U, angle);
    validate(cut, "cut");
    expect_same_points(tube(), cut);
    expect_same_points(tube(), with_knot(cut, Direction::U, angle + 0.03));
  }
}

TEST(KnotInsertion, KeepsWeightsOfOneAndThoseOfTheLawOfAngles) {
  const BezierSurface plain = with_knot(cubic(), Direction::U, 0.3);
  for (const RationalBezierPatch& patch : plain.patches.values())
    for (const Vec4& p : patch.points.values()) EXPECT_EQ(p[3], 1);
  const BezierSurface cut = with_knot(tube(), Direction::U, 0.25);
  for (int i = 0; i < 2; ++i) {
    const auto span = static_cast<std::size_t>(i);
    const double w = std::cos((cut.u_knots[span + 1] - cut.u_knots[span]) / 2);
    EXPECT_NEAR(cut.patches(i, 0).points(0, 0)[3], 1, 1e-15);
    EXPECT_NEAR(cut.patches(i, 0).points(1, 0)[3], w, 1e-15);
    EXPECT_NEAR(cut.patches(i, 0).points(2, 0)[3], 1, 1e-15);
  }
}

TEST(KnotInsertion, LeavesBordersInCommonBitForBit) {
  const BezierSurface across = with_knot(tube(), Direction::V, 2.5);
  const BezierSurface cut = with_knot(across, Direction::U, 0.25);
  for (int i = 0; i + 1 < cut.patches.rows(); ++i)
    for (int j = 0; j < cut.patches.columns(); ++j)
      for (int k = 0; k < 2; ++k)
        EXPECT_EQ(cut.patches(i, j).points(2, k), cut.patches(i + 1, j).points(0, k));
  for (int i = 0; i < cut.patches.rows(); ++i)
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(cut.patches(i, 0).points(k, 1), cut.patches(i, 1).points(k, 0));
}

TEST(KnotInsertion, RefusesKnotsThatAreThereOrOutside) {
  for (const double knot : {-1.0, 0.0, pi / 3, 2 * pi / 3, 4.0, std::nan("")})
    EXPECT_THROW(with_knot(tube(), Direction::U, knot), InvalidInput) << knot;
}

}  // namespace
}  // namespace blossom
