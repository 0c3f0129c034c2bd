// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/errors.h"
#include "core/base/unbounded.h"
#include "core/distance.h"
#include "tests/support/quadric_patches.h"
#include "tests/support/shapes.h"
#include "tests/support/solids.h"

namespace blossom {
namespace {

constexpr double kUnknown = -kInfinity;

// z = height(i, j) over the unit square.
BezierSurface graph(const Grid<double>& heights) {
  RationalBezierPatch patch{Grid<Vec4>(heights.rows(), heights.columns())};
  for (int i = 0; i < heights.rows(); ++i)
    for (int j = 0; j < heights.columns(); ++j)
      patch.points(i, j) = {i / (heights.rows() - 1.0), j / (heights.columns() - 1.0),
                            heights(i, j), 1};
  return testing::one_patch(patch);
}

// 16 u (1 - u) v (1 - v) over the unit square: 1 in the middle, 0 on the border.
BezierSurface dome() {
  Grid<double> heights(3, 3, 0);
  heights(1, 1) = 4;
  return graph(heights);
}

void expect_farthest(const DistanceOperand& set, int axis, bool backwards, double expected) {
  constexpr double kResolution = 1e-9;
  const FarthestResult found =
      farthest_along(PreparedSet(set), axis, backwards, kUnknown, {.resolution = kResolution});
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_LE(found.lower, expected + 1e-15);
  EXPECT_GE(found.upper, expected);
  EXPECT_LE(found.upper - found.lower, kResolution);
}

TEST(FarthestAlong, OfASurfaceIsAtItsTop) {
  expect_farthest(measured(dome()), 2, false, 1);
  expect_farthest(measured(dome()), 2, true, 0);
  expect_farthest(measured(dome()), 0, false, 1);
}

TEST(FarthestAlong, OfARationalSurfaceIsThatOfTheSurface) {
  const RationalBezierPatch octant = testing::sphere_octant({1, 2, 3}, 2);
  for (int axis = 0; axis < 3; ++axis) {
    double most = kUnknown, least = -kUnknown;
    constexpr int kSteps = 64;
    for (int i = 0; i <= kSteps; ++i)
      for (int j = 0; j <= kSteps; ++j) {
        const double at =
            projected(testing::reference_point(octant, i * 1.0 / kSteps, j * 1.0 / kSteps))[axis];
        most = std::max(most, at);
        least = std::min(least, at);
      }
    expect_farthest(measured(testing::one_patch(octant)), axis, false, most);
    expect_farthest(measured(testing::one_patch(octant)), axis, true, -least);
  }
}

TEST(FarthestAlong, OfACurveIsWhereItTurns) {
  // t (1 - t) (1 + t) has its largest value at 1 / sqrt(3).
  const RationalBezierCurve curve{
      {{0, 0, 0, 1}, {1, 0, 1. / 3, 1}, {2, 0, 2. / 3, 1}, {3, 0, 0, 1}}};
  expect_farthest(measured(curve), 2, false, 2 / (3 * std::sqrt(3)));
}

// Two planes that meet in a ridge: no derivative across it vanishes there.
TEST(FarthestAlong, FindsTheTopOfARidge) {
  BezierSurface roof{.u_knots = {0, 1, 2}, .v_knots = {0, 1}};
  roof.patches = Grid<RationalBezierPatch>(2, 1);
  for (int i = 0; i < 2; ++i) {
    Grid<Vec4>& net = roof.patches(i, 0).points;
    net = Grid<Vec4>(2, 3);
    for (int j = 0; j < 3; ++j) {
      const double ridge = j == 1 ? 3 : 1;
      net(0, j) = {1. * i, 0.5 * j, i == 0 ? 0 : ridge, 1};
      net(1, j) = {1. * i + 1, 0.5 * j, i == 0 ? ridge : 0, 1};
    }
  }
  expect_farthest(measured(roof), 2, false, 2);
}

// What is left of the dome is beside its middle, and goes farthest on its new border.
TEST(FarthestAlong, LeavesOutWhatTrimsDo) {
  DistanceOperand set = measured(dome());
  set.trims = [](int, const Vec2&, const Vec2& high) {
    return high[0] < 0.3 ? TrimSide::Inside : TrimSide::Mixed;
  };
  expect_farthest(set, 2, false, 1);
  set.trims = [](int, const Vec2& low, const Vec2& high) {
    if (low[0] > 0.3) return TrimSide::Outside;
    return high[0] < 0.3 ? TrimSide::Inside : TrimSide::Mixed;
  };
  const double middle = 8 * 0.3 * 0.7;
  set.curves.push_back({{{0.3, 0, 0, 1}, {0.3, 0.5, middle, 1}, {0.3, 1, 0, 1}}});
  expect_farthest(set, 2, false, middle / 2);
}

// z = x up to 1 over the unit square; what stands for the border there ends at 0.99.
TEST(FarthestAlong, AllowsForBordersThatAreOffTheirCurves) {
  Grid<double> heights(2, 2, 0);
  heights(1, 0) = heights(1, 1) = 1;
  const auto found_with = [&](double gap, bool known = false) {
    OperandParts parts;
    parts.points = {{0.99, 0, 0.99}, {0.99, 1, 0.99}};
    parts.hulls = {{.points = {{0, 0, 0}, {0, 1, 0}, {1, 0, 1}, {1, 1, 1}}, .border_gap = gap}};
    parts.make = [&](int) { return DistanceOperand{{}, {}, {graph(heights)}}; };
    parts.trims = [](int, const Vec2&, const Vec2& high) {
      return high[0] < 0.995 ? TrimSide::Inside : TrimSide::Outside;
    };
    if (known)
      parts.borders = [](int) {
        return BorderCurves{{{{{0.995, 0, 0.995, 1}, {0.995, 1, 0.995, 1}}}}, 0};
      };
    return farthest_along(PreparedSet(std::move(parts)), 2, false, kUnknown, {.resolution = 1e-6});
  };
  const FarthestResult tight = found_with(0);
  EXPECT_EQ(tight.lower, 0.99);
  EXPECT_EQ(tight.upper, 0.99);
  const FarthestResult loose = found_with(0.008);
  EXPECT_GE(loose.upper, 0.995);
  EXPECT_LE(loose.upper, 0.998 + 1e-12);
  const FarthestResult known = found_with(0.008, true);
  EXPECT_EQ(known.lower, 0.995);
  EXPECT_LE(known.upper, 0.995 + 1e-6);
}

// z = x up to 1 over the unit square, but for a border at 0.5, and 0.7 without.
TEST(FarthestAlong, MakesNoBorderThatCurvesKeepFromComingAsFar) {
  Grid<double> heights(2, 2, 0);
  heights(1, 0) = heights(1, 1) = 1;
  for (const bool known : {false, true}) {
    int made = 0;
    OperandParts parts;
    parts.points = {{0.7, 0, 0.7}};
    parts.hulls = {{.points = {{0, 0, 0}, {0, 1, 0}, {1, 0, 1}, {1, 1, 1}}, .border_gap = 0.008}};
    if (known) parts.hulls[0].border_points = {{0, 0, 0}, {0.5, 1, 0.5}};
    parts.make = [&](int) { return DistanceOperand{{}, {}, {graph(heights)}}; };
    parts.trims = [](int, const Vec2&, const Vec2& high) {
      return high[0] < 0.5 ? TrimSide::Inside : TrimSide::Outside;
    };
    parts.borders = [&](int) {
      ++made;
      return BorderCurves{{{{{0.5, 0, 0.5, 1}, {0.5, 1, 0.5, 1}}}}, 0};
    };
    const FarthestResult found =
        farthest_along(PreparedSet(std::move(parts)), 2, false, kUnknown, {.resolution = 1e-6});
    EXPECT_EQ(found.lower, 0.7);
    EXPECT_LE(found.upper, 0.7 + 1e-6);
    EXPECT_EQ(made, known ? 0 : 1);
  }
}

TEST(FarthestAlong, LooksAtNothingThatIsNoFartherThanWhatIsKnown) {
  const FarthestResult found = farthest_along(PreparedSet(measured(dome())), 2, false, 5);
  EXPECT_EQ(found.cells, 0);
  EXPECT_EQ(found.lower, 5);
  EXPECT_EQ(found.upper, 5);
}

// A top all along a line across the parameters: cells grow as the root of the resolution does.
TEST(FarthestAlong, StaysWithinItsBudgetAndSaysHowFarItCame) {
  // 1 - (u - v)^2 in Bernstein form.
  Grid<double> heights(3, 3);
  const std::array<double, 3> square{0, 0, 1}, line{0, 0.5, 1};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
      heights(i, j) = 1 - square[a] + 2 * line[a] * line[b] - square[b];
    }
  const PreparedSet set(measured(graph(heights)));
  const FarthestResult all = farthest_along(set, 2, false, kUnknown, {.resolution = 1e-6});
  EXPECT_EQ(all.status, Status::Complete);
  EXPECT_LE(all.upper - all.lower, 1e-6);
  const FarthestResult some =
      farthest_along(set, 2, false, kUnknown, {.budget = 50, .resolution = 1e-12});
  EXPECT_EQ(some.status, Status::Stopped);
  EXPECT_GE(some.upper, 1);
  EXPECT_LE(some.cells, 52);
}

TEST(FarthestAlong, RefusesAnAxisThatIsNone) {
  const PreparedSet set(measured(Vec3{1, 2, 3}));
  EXPECT_THROW(farthest_along(set, 3, false, kUnknown), InvalidInput);
  EXPECT_EQ(farthest_along(set, 1, true, kUnknown).upper, -2);
}

}  // namespace
}  // namespace blossom
