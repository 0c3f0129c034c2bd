// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "core/base/errors.h"
#include "core/subdivision/patch_subdivision.h"
#include "tests/support/shapes.h"
#include "tests/support/solids.h"

namespace blossom {
namespace {

using testing::one_patch;
using testing::random_point;
using testing::reference_point;
using testing::seeded;
using testing::uniform;

BezierSurface moved_by(BezierSurface surface, const Vec3& by) {
  for (RationalBezierPatch& patch : surface.patches.values())
    for (Vec4& p : patch.points.values())
      for (int k = 0; k < 3; ++k) p[k] += p[3] * by[k];
  return surface;
}

RationalBezierCurve segment(const Vec3& from, const Vec3& to) {
  return {{testing::weighted(from, 1), testing::weighted(to, 1)}};
}

void expect_distance(const DistanceResult& found, double expected) {
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_LE(found.lower, expected * (1 + 1e-15) + 1e-15);
  EXPECT_GE(found.upper, expected * (1 - 1e-14) - 1e-15);
  // All coordinates here sum to less than 10.
  EXPECT_LE(found.upper - found.lower,
            std::max(kDistanceAccuracy * expected, 10 * kDistanceResolution));
  EXPECT_NEAR(distance(found.a.point, found.b.point), found.upper, 1e-15 * (1 + expected));
}

TEST(LeastDistance, OfPointsIsTheirs) {
  expect_distance(least_distance(measured(Vec3{1, 2, 3}), measured(Vec3{1, 2, 5})), 2);
  expect_distance(least_distance(measured(Vec3{1, 2, 3}), measured(Vec3{1, 2, 3})), 0);
}

TEST(LeastDistance, OfAPointAndASegmentIsTakenInsideOrAtAnEnd) {
  const DistanceOperand line = measured(segment({0, 0, 0}, {4, 0, 0}));
  const DistanceResult inside = least_distance(measured(Vec3{1, 2, 0}), line);
  expect_distance(inside, 2);
  EXPECT_EQ(inside.b.kind, DistanceEnd::Kind::Curve);
  EXPECT_NEAR(inside.b.uv[0], 0.25, 1e-12);
  const DistanceResult end = least_distance(measured(Vec3{7, 4, 0}), line);
  expect_distance(end, 5);
  EXPECT_EQ(end.b.point, (Vec3{4, 0, 0}));
}

TEST(LeastDistance, OfSkewSegmentsIsThatOfTheirCommonNormal) {
  expect_distance(least_distance(measured(segment({-1, 0, 0}, {1, 0, 0})),
                                 measured(segment({0.2, -1, 0.5}, {0.4, 1, 0.5}))),
                  0.5);
}

TEST(LeastDistance, ToASphereIsKnown) {
  auto random = seeded(3);
  const DistanceOperand sphere = measured(testing::unit_sphere());
  for (int i = 0; i < 50; ++i) {
    const Vec3 point = 3 * random_point(random);
    expect_distance(least_distance(measured(point), sphere), std::abs(norm(point) - 1));
    expect_distance(least_distance(sphere, measured(point)), std::abs(norm(point) - 1));
  }
  expect_distance(least_distance(measured(Vec3{0, 0, 3}), sphere), 2);
}

TEST(LeastDistance, FromTheCentreOfASphereIsItsRadius) {
  const DistanceResult found =
      least_distance(measured(testing::unit_sphere()), measured(Vec3{0, 0, 0}));
  expect_distance(found, 1);
  EXPECT_LE(found.pairs, 1000);
}

TEST(LeastDistance, OfTwoSpheresIsKnown) {
  const DistanceOperand sphere = measured(testing::unit_sphere());
  for (const Vec3& by : {Vec3{3, 0.1, -0.2}, Vec3{1.2, 1.5, 1.7}, Vec3{0.4, 0.3, 5}})
    expect_distance(least_distance(sphere, measured(moved_by(testing::unit_sphere(), by))),
                    norm(by) - 2);
}

TEST(LeastDistance, OfParallelSquaresIsTheirGap) {
  const BezierSurface square = testing::quadrilateral({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0});
  expect_distance(least_distance(measured(square), measured(moved_by(square, {0.3, 0.2, 0.75}))),
                  0.75);
  expect_distance(least_distance(measured(square), measured(moved_by(square, {1.5, 1.5, 0}))),
                  std::sqrt(0.5));
}

TEST(LeastDistance, FindsTheEdgeOfAKink) {
  // A roof of two patches with its ridge at y = 0, z = 1.
  BezierSurface roof = testing::quadrilateral({0, -1, 0}, {0, 0, 1}, {2, -1, 0}, {2, 0, 1});
  const BezierSurface right = testing::quadrilateral({0, 0, 1}, {0, 1, 0}, {2, 0, 1}, {2, 1, 0});
  Grid<RationalBezierPatch> both(1, 2);
  both(0, 0) = roof.patches(0, 0);
  both(0, 1) = right.patches(0, 0);
  roof.patches = both;
  roof.v_knots = {0, 1, 2};
  expect_distance(least_distance(measured(Vec3{0.7, 0, 3}), measured(roof)), 2);
}

// Two patches that meet in a ridge of these heights, at y = 0.
BezierSurface roof_with_ridge(const std::array<double, 5>& heights) {
  BezierSurface roof;
  roof.u_knots = {0, 1};
  roof.v_knots = {0, 1, 2};
  roof.patches = Grid<RationalBezierPatch>(1, 2);
  for (int side = 0; side < 2; ++side) {
    RationalBezierPatch& patch = roof.patches(0, side);
    patch.points = Grid<Vec4>(5, 2);
    for (int i = 0; i < 5; ++i) {
      patch.points(i, 1 - side) = {double(i), 0, heights[static_cast<std::size_t>(i)], 1};
      patch.points(i, side) = {double(i), side == 0 ? -1.0 : 1.0, -9, 1};
    }
  }
  return roof;
}

TEST(LeastDistance, FindsTheHigherPeakOfAKinkedRidge) {
  // Neither peak is stationary on its sides, and the slope in the middle leads to the lower one.
  for (const std::array<double, 5>& heights :
       {std::array<double, 5>{-4, 5, -4, 2, 0}, std::array<double, 5>{0, 2, -4, 5, -4}}) {
    const BezierSurface roof = roof_with_ridge(heights);
    const Vec3 point{2, 0, 100};
    double sampled = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= 1000; ++i)
      sampled = std::min(sampled, distance(point, point_at(roof, {i / 1000.0, 1})));
    const DistanceResult found = least_distance(measured(point), {{}, {}, {roof}});
    EXPECT_LE(found.lower, sampled);
    EXPECT_LE(found.upper, sampled + 1e-12);
    EXPECT_GE(found.upper, sampled - 1e-5);
  }
}

TEST(LeastDistance, FindsTheKinkBetweenLegsThatAreParallelByDifferentNumbers) {
  // The legs (1, 0, z) at the border are 1, 4 and 1 times as long behind it: in its middle, the
  // highest point, the slope turns from 0.15 up to 0.15 / 3 down.
  BezierSurface bump;
  bump.u_knots = {0, 1, 2};
  bump.v_knots = {0, 1};
  bump.patches = Grid<RationalBezierPatch>(2, 1);
  const std::array<double, 3> border{0, 4, 0}, slope{1, -0.2, 0}, length{1, 4, 1};
  for (int j = 0; j < 3; ++j) {
    const auto k = static_cast<std::size_t>(j);
    for (int side = 0; side < 2; ++side) {
      Grid<Vec4>& net = bump.patches(side, 0).points;
      if (j == 0) net = Grid<Vec4>(2, 3);
      const double across = side == 0 ? -1 : length[k];
      net(1 - side, j) = {0, 0.5 * j, border[k], 1};
      net(side, j) = {across, 0.5 * j, border[k] + across * slope[k], 1};
    }
  }
  expect_distance(least_distance(measured(Vec3{0, 0.5, 9}), measured(bump)), 7);
}

TEST(LeastDistance, TakesLinesBetweenPartsOfOneBallForSmooth) {
  // Only what is higher than 1/2 is there. Below, cells on the meridians between quarters are
  // nearer.
  DistanceOperand cap{{}, {}, {testing::unit_sphere()}};
  const double latitude = std::numbers::pi / 6;
  for (int i = 0; i < 4; ++i) {
    const RationalBezierPatch& quarter = cap.surfaces[0].patches(i, 1);
    const double t = local_parameter(ParameterLaw::Angle, {0, std::numbers::pi / 2}, latitude);
    const Grid<Vec4> rest = sub_patch(quarter, {0, 1}, {t, 1}).points;
    cap.curves.push_back({{rest(0, 0), rest(1, 0), rest(2, 0)}});
  }
  cap.trims = [latitude](int, const Vec2& low, const Vec2& high) {
    return high[1] < latitude  ? TrimSide::Outside
           : low[1] > latitude ? TrimSide::Inside
                               : TrimSide::Mixed;
  };
  const Vec3 point{0.3, 0.1, -0.4};
  const double across = std::cos(latitude) - std::hypot(0.3, 0.1);
  const DistanceResult found = least_distance(measured(point), cap);
  expect_distance(found, std::hypot(across, 0.9));
  EXPECT_LE(found.pairs, 50);
}

TEST(LeastDistance, TakesPatchesOfDifferentDegreesForAKink) {
  BezierSurface roof = roof_with_ridge({0, 0, 1, 0, 0});
  Grid<Vec4>& left = roof.patches(0, 0).points;
  const Grid<Vec4> linear = left;
  left = Grid<Vec4>(2, 2);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) left(i, j) = linear(4 * i, j);
  expect_distance(least_distance(measured(Vec3{2, 0, 5}), {{}, {}, {roof}}), 5 - 0.375);
}

TEST(LeastDistance, OfSurfacesThatCrossIsZero) {
  const DistanceResult found = least_distance(
      measured(testing::unit_sphere()), measured(moved_by(testing::unit_sphere(), {0.9, 0.3, 0})));
  EXPECT_EQ(found.lower, 0);
  EXPECT_LE(found.upper, 1e-13);
}

TEST(LeastDistance, StopsWhenItsSideOfALimitIsKnown) {
  const DistanceOperand sphere = measured(testing::unit_sphere());
  const DistanceOperand other = measured(moved_by(testing::unit_sphere(), {3, 0, 0}));
  const DistanceResult above = least_distance(sphere, other, {.enough = 0.5});
  EXPECT_GT(above.lower, 0.5);
  EXPECT_LE(above.lower, 1);
  const DistanceResult below = least_distance(sphere, other, {.enough = 1.5});
  EXPECT_LE(below.upper, 1.5);
  EXPECT_LE(above.pairs, least_distance(sphere, other).pairs);
}

TEST(LeastDistance, KeepsItsBoundsWhenTheBudgetIsSpent) {
  // Two tubes about the same circle are as far apart everywhere.
  const DistanceResult found = least_distance(measured(testing::torus(3, 1)),
                                              measured(testing::torus(3, 2)), {.budget = 4'000});
  EXPECT_EQ(found.status, Status::Stopped);
  EXPECT_LE(found.lower, 1);
  EXPECT_GE(found.lower, 0.5);
  EXPECT_NEAR(found.upper, 1, 1e-14);
}

TEST(LeastDistance, KeepsItsBoundsWhenTheTimeIsSpentOrItIsCancelled) {
  const DistanceOperand a = measured(testing::unit_sphere());
  const DistanceOperand b = measured(Vec3{3, 0.2, 0.1});
  const double expected = norm(Vec3{3, 0.2, 0.1}) - 1;
  const auto expect_stopped = [&](const DistanceOptions& options) {
    const DistanceResult found = least_distance(a, b, options);
    EXPECT_EQ(found.status, Status::Stopped);
    EXPECT_LE(found.lower, expected);
    EXPECT_GE(found.upper, expected);
  };
  expect_stopped({.time_limit = 1e-9});
  expect_stopped({.cancelled = [] { return true; }});
}

TEST(LeastDistance, EndsWhereTheSurfaceGoesOnAlmostAsNearBeyondItsTrims) {
  // About the origin, of a radius that grows with the cube of a parameter, by less than 1e-4. It is
  // trimmed a little behind the circle where that is stationary.
  const double at = 0.4, cut = 0.45, growth = 1e-4;
  BezierSurface ball = testing::revolved_circle(0, 1, -std::numbers::pi / 2, 2);
  RationalBezierPatch quarter = ball.patches(0, 0), whole{Grid<Vec4>(3, 6)};
  const auto cube = [&](double t) { return 1 + growth * std::pow(t - at, 3); };
  // Bezier points of 1 + growth (t - at)^3.
  const std::array<double, 4> c{cube(0), 1 + growth * at * at * (1 - at),
                                1 - growth * at * (1 - at) * (1 - at), cube(1)};
  const std::array<double, 3> two{1, 2, 1};
  const std::array<double, 4> three{1, 3, 3, 1};
  const std::array<double, 6> five{1, 5, 10, 10, 5, 1};
  for (int i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 4; ++k) {
        const Vec4& p = quarter.points(i, static_cast<int>(j));
        const double part = two[j] * three[k] / five[j + k];
        Vec4& q = whole.points(i, static_cast<int>(j + k));
        for (int x = 0; x < 3; ++x) q[x] += part * c[k] * p[x];
        q[3] += part * p[3];
      }
  DistanceOperand part{{}, {}, {one_patch(whole)}};
  const Grid<Vec4> rest = sub_patch(whole, {0, 1}, {cut, 1}).points;
  part.curves = {RationalBezierCurve{{rest(0, 0), rest(1, 0), rest(2, 0)}}};
  part.trims = [cut](int, const Vec2& low, const Vec2& high) {
    return high[1] < cut ? TrimSide::Outside : low[1] > cut ? TrimSide::Inside : TrimSide::Mixed;
  };
  const DistanceResult found = least_distance(measured(Vec3{0, 0, 0}), part);
  expect_distance(found, cube(cut));
  EXPECT_LE(found.pairs, 20'000);
}

TEST(LeastDistance, LeavesOutWhatIsTrimmedAway) {
  // Of the square only x > 1/2 is there; its cut border is no part of this set.
  DistanceOperand part =
      measured(testing::quadrilateral({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}));
  part.points.clear();
  part.curves = {segment({0.5, 0, 0}, {0.5, 1, 0})};
  part.trims = [](int, const Vec2& low, const Vec2& high) {
    return high[0] < 0.5 ? TrimSide::Outside : low[0] > 0.5 ? TrimSide::Inside : TrimSide::Mixed;
  };
  expect_distance(least_distance(measured(Vec3{0.75, 0.4, 1}), part), 1);
  expect_distance(least_distance(measured(Vec3{0.2, 0.4, 0.4}), part), 0.5);
}

TEST(LeastDistance, EndsForPointsHardlyOffASurface) {
  // Far from the origin, so that roundings of coordinates are larger than the distance.
  const DistanceOperand sphere = measured(moved_by(testing::unit_sphere(), {20, 10, 5}));
  const Vec3 normal = unit(Vec3{1, 2, 3});
  for (const double off : {0.0, 1e-14, 1e-12, 1e-9, 1e-6, 1e-3}) {
    const Vec3 point = Vec3{20, 10, 5} + (1 + off) * normal;
    const DistanceResult found = least_distance(measured(point), sphere);
    EXPECT_EQ(found.status, Status::Complete) << off;
    EXPECT_LE(found.lower, off + 1e-14);
    EXPECT_NEAR(found.upper, off, 1e-13);
    EXPECT_LE(found.pairs, 500) << off;
  }
}

TEST(LeastDistance, EndsForPointsNearTheCentreOfASphere) {
  const DistanceOperand sphere = measured(testing::unit_sphere());
  for (const double off : {1e-14, 1e-11, 1e-8, 1e-5, 1e-3}) {
    const DistanceResult found = least_distance(measured(off * unit(Vec3{1, 2, 3})), sphere);
    EXPECT_EQ(found.status, Status::Complete) << off;
    EXPECT_LE(found.lower, 1 - off + 1e-14);
    EXPECT_NEAR(found.upper, 1 - off, 4e-10);
    EXPECT_LE(found.pairs, 2000) << off;
  }
}

TEST(LeastDistance, OfConvexPartsNeedsFewPairs) {
  // Where the square of the distance is convex nothing is halved down to the accuracy.
  const DistanceResult found = least_distance(
      measured(testing::unit_sphere()), measured(moved_by(testing::unit_sphere(), {3, 0.1, -0.2})));
  EXPECT_LE(found.upper - found.lower, 1e-12);
  EXPECT_LE(found.pairs, 400);
}

TEST(LeastDistance, MakesOnlyPartsThatMatter) {
  // Short segments in two rows, one behind the other.
  const auto row = [](double x, std::vector<int>& made) {
    OperandParts parts;
    for (int i = 0; i < 12; ++i) {
      const Vec3 start{x + i, 0, 0};
      parts.hulls.push_back({{start, start + Vec3{0.01, 0, 0}}, 0});
    }
    parts.make = [x, &made](int part) {
      made.push_back(part);
      return measured(segment({x + part, 0, 0}, {x + part + 0.01, 0, 0}));
    };
    return PreparedSet(std::move(parts));
  };
  std::vector<int> made_a, made_b;
  const PreparedSet a = row(0, made_a), b = row(20, made_b);
  const DistanceResult found = least_distance(a, b);
  EXPECT_NEAR(found.upper, 20 - 11.01, 1e-13);
  EXPECT_EQ(found.a.part, 11);
  EXPECT_EQ(found.b.part, 0);
  EXPECT_EQ(made_a, std::vector<int>{11});
  EXPECT_EQ(made_b, std::vector<int>{0});
}

TEST(ProvenToCross, IsNothingThatIsApproximated) {
  RationalBezierPatch floor{Grid<Vec4>(2, 2)}, wall{Grid<Vec4>(2, 2)};
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      floor.points(i, j) = {double(i), double(j), 0, 1};
      wall.points(i, j) = {0.3, double(i), j - 0.4, 1};
    }
  BezierSurface exact = one_patch(wall), fitted = exact;
  fitted.error = 1e-3;
  const PreparedSet ground(DistanceOperand{{}, {}, {one_patch(floor)}});
  const auto crosses = [&](const BezierSurface& other) {
    return proven_to_cross(ground, 0, PreparedSet(DistanceOperand{{}, {}, {other}}), 0,
                           {0.3, 0.5, 0}, 1e-6);
  };
  EXPECT_TRUE(crosses(exact));
  EXPECT_FALSE(crosses(fitted));
}

TEST(LeastDistance, RefusesWhatIsNotThere) {
  const DistanceOperand point = measured(Vec3{0, 0, 0});
  EXPECT_THROW(least_distance({}, point), InvalidInput);
  EXPECT_THROW(least_distance(point, measured(Vec3{0, std::nan(""), 0})), InvalidInput);
  EXPECT_THROW(measured(RationalBezierCurve{}), InvalidInput);
}

// Random patches and curves: no pair of samples is nearer, and the order does not matter.
class LeastDistanceProperty : public ::testing::TestWithParam<int> {};

TEST_P(LeastDistanceProperty, IsNeverMoreThanThatOfSamples) {
  auto random = seeded(GetParam());
  const int n = 1 + GetParam() % 4, m = 1 + GetParam() / 4 % 4;
  const auto net = [&](const Vec3& by, double largest_weight) {
    RationalBezierPatch patch{Grid<Vec4>(n + 1, m + 1)};
    for (Vec4& p : patch.points.values())
      p = testing::weighted(random_point(random) + by, uniform(random, 1, largest_weight));
    return patch;
  };
  const RationalBezierPatch a = net({0, 0, 0}, 1 + GetParam() % 3);
  const RationalBezierPatch b = net({uniform(random, 1, 3), 0.5, 0}, 1);
  const DistanceOperand set_a = measured(one_patch(a)), set_b = measured(one_patch(b));

  const DistanceResult found = least_distance(set_a, set_b), turned = least_distance(set_b, set_a);

  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_LE(found.lower, turned.upper);
  EXPECT_LE(turned.lower, found.upper);
  EXPECT_LE(found.upper - found.lower,
            std::max(kDistanceAccuracy * found.upper, 10 * kDistanceResolution));
  double sampled = std::numeric_limits<double>::infinity();
  const auto point = [](const RationalBezierPatch& patch, double u, double v) {
    const Vec4 p = reference_point(patch, u, v);
    return Vec3{p[0], p[1], p[2]} * (1 / p[3]);
  };
  std::vector<Vec3> of_b;
  for (int i = 0; i <= 144; ++i) of_b.push_back(point(b, i % 12 / 11.0, i / 12 / 12.0));
  for (int i = 0; i <= 144; ++i) {
    const Vec3 p = point(a, i % 12 / 11.0, i / 12 / 12.0);
    for (const Vec3& q : of_b) sampled = std::min(sampled, distance(p, q));
  }
  EXPECT_LE(found.lower, sampled);
  EXPECT_LE(found.upper, sampled + 1e-14);
}

INSTANTIATE_TEST_SUITE_P(Seeds, LeastDistanceProperty, ::testing::Range(0, 32));

}  // namespace
}  // namespace blossom
