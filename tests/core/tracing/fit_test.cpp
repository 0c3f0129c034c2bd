// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tracing/fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <vector>

#include "core/surface_intersection.h"
#include "tests/core/tracing/surface_pairs.h"
#include "tests/support/surface_changes.h"

namespace blossom {
namespace {

using testing::surface_pairs;
using testing::SurfacePair;

RationalBezierPatch patch_of(int rows, const std::vector<Vec3>& points) {
  RationalBezierPatch patch{Grid<Vec4>(rows, static_cast<int>(points.size()) / rows)};
  for (std::size_t i = 0; i < points.size(); ++i)
    patch.points.values()[i] = {points[i][0], points[i][1], points[i][2], 1};
  return patch;
}

// Open CASCADE takes 114 poles for the same curve and tolerance.
TEST(Fit, OfALoopTakesFewPoles) {
  const testing::CubicPair pair = testing::cubic_pair(testing::loop(0.43, 0.57, 0.2));

  const SurfaceIntersection found = intersect(pair.a, pair.b);

  ASSERT_EQ(found.curves.size(), 1u);
  const IntersectionCurve& curve = found.curves[0];
  EXPECT_LE(curve.curve.points.size(), 40u);
  EXPECT_EQ(curve.curve.degree, 5);
  EXPECT_TRUE(curve.closed);
  EXPECT_TRUE(curve.deviation.proven);
  EXPECT_LE(std::max({curve.deviation.a, curve.deviation.b, curve.deviation.between}), 1e-7);
}

// There coordinates are multiples of 6e-11, and crossings at small angles no more precise than some
// hundred times that: more knots would fit nothing but rounding.
TEST(Fit, OfALoopFarFromTheOriginTakesFewPoles) {
  testing::CubicPair pair = testing::cubic_pair(testing::loop(0.43, 0.57, 0.001));
  for (BezierSurface* surface : {&pair.a, &pair.b})
    for (Vec4& p : surface->patches(0, 0).points.values()) p += Vec4{3e5, 2e5, -1e5, 0};

  const SurfaceIntersection found = intersect(pair.a, pair.b);

  ASSERT_EQ(found.curves.size(), 1u);
  const IntersectionCurve& curve = found.curves[0];
  EXPECT_LE(curve.curve.points.size(), 60u);
  EXPECT_TRUE(curve.closed);
  EXPECT_LE(std::max({curve.deviation.a, curve.deviation.b, curve.deviation.between}), 1e-7);
}

TEST(Fit, OfAStraightLineIsOneSpan) {
  const auto found = intersect(testing::plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}),
                               testing::plane({0.3, -1, -1}, {0, 3, 0}, {0, 0, 2}));

  ASSERT_EQ(found.curves.size(), 1u);
  EXPECT_EQ(found.curves[0].curve.points.size(), 6u);
  EXPECT_NEAR(found.curves[0].length, 1, 1e-14);
}

// The unit cylinder from z = -1 to 1 as one patch: the square of a complex quadratic in u over its
// norm goes round the whole circle.
BezierSurface cylinder_of_one_patch() {
  constexpr std::array<Vec3, 6> kCircle{{{1, 0, 1},
                                         {0.2, 0.8, 0.2},
                                         {-0.6, 0.4, 0.2},
                                         {-0.6, -0.4, 0.2},
                                         {0.2, -0.8, 0.2},
                                         {1, 0, 1}}};
  Grid<Vec4> net(6, 2);
  for (int i = 0; i < 6; ++i) {
    const auto& [x, y, w] = kCircle[static_cast<std::size_t>(i)].coordinates;
    net(i, 0) = {x, y, -w, w};
    net(i, 1) = {x, y, w, w};
  }
  BezierSurface surface{{0, 1}, {0, 1}};
  surface.rational = true;
  surface.patches = Grid<RationalBezierPatch>(1, 1, RationalBezierPatch{net});
  return surface;
}

// The ends of its only link are one point.
TEST(Fit, OfALoopInOnePatchGoesRound) {
  const BezierSurface tube = cylinder_of_one_patch();
  BezierSurface saddle = testing::plane({-20, -21, -2.5}, {40, 1, 3}, {-2, 41, 2});
  const BezierSurface plane = saddle;
  saddle.patches(0, 0).points(0, 1)[2] -= 5;
  saddle.patches(0, 0).points(1, 1)[2] += 5;

  for (const BezierSurface& other : {plane, saddle})
    for (const bool exchanged : {false, true}) {
      const auto found = exchanged ? intersect(other, tube) : intersect(tube, other);

      EXPECT_EQ(found.status, Status::Complete);
      ASSERT_EQ(found.curves.size(), 1u);
      const IntersectionCurve& curve = found.curves[0];
      EXPECT_EQ(curve.curve.points.front(), curve.curve.points.back());
      EXPECT_GT(curve.length, 2 * std::numbers::pi);
      EXPECT_LT(curve.length, 2.1 * std::numbers::pi);
      EXPECT_LE(std::max({curve.deviation.a, curve.deviation.b, curve.deviation.between}), 1e-7);
    }
}

class FitOf : public ::testing::TestWithParam<SurfacePair> {};

// Of each pair at least one.
std::vector<IntersectionCurve> curves_of(const SurfacePair& pair) {
  std::vector<IntersectionCurve> curves = intersect(pair.a, pair.b).curves;
  EXPECT_FALSE(curves.empty());
  return curves;
}

TEST_P(FitOf, BeginsAndEndsInTheTracedPointsExactly) {
  for (const IntersectionCurve& curve : curves_of(GetParam())) {
    EXPECT_EQ(curve.curve.points.front(), curve.samples.front().point);
    EXPECT_EQ(curve.chart_a.points.front(), curve.samples.front().uv_a);
    EXPECT_EQ(curve.chart_b.points.front(), curve.samples.front().uv_b);
    EXPECT_EQ(curve.curve.points.back(), curve.samples.back().point);
    EXPECT_EQ(curve.chart_a.points.back(), curve.samples.back().uv_a);
    EXPECT_EQ(curve.chart_b.points.back(), curve.samples.back().uv_b);
    if (curve.closed) {
      EXPECT_EQ(curve.curve.points.front(), curve.curve.points.back());
    }
  }
}

TEST_P(FitOf, IsParametrisedByArcLengthUnlessItIsAConic) {
  for (const IntersectionCurve& curve : curves_of(GetParam())) {
    if (curve.conic) continue;
    EXPECT_EQ(curve.curve.domain(), (Interval{0, curve.length}));
    for (int i = 0; i <= 200; ++i) {
      const double t = at(curve.curve.domain(), (i + 0.5) / 201);
      EXPECT_NEAR(norm(derivative_at(curve.curve, t)), 1, 1e-4);
    }
  }
}

// Derivatives of every order that the knot's multiplicity leaves agree from both sides.
TEST_P(FitOf, HasItsTangentOnBothSidesOfAKnot) {
  for (const IntersectionCurve& curve : curves_of(GetParam()))
    for (std::size_t i = 1; i + 1 < curve.curve.knots.size(); ++i) {
      if (curve.curve.multiplicities[i] >= 5) continue;
      const double h = 1e-9 * curve.length, t = curve.curve.knots[i];
      EXPECT_LE(distance(derivative_at(curve.curve, t - h), derivative_at(curve.curve, t + h)),
                1e-6);
    }
}

TEST_P(FitOf, HoldsTheTolerance) {
  for (const double tolerance : {1e-3, 1e-5, 1e-7, 1e-9}) {
    IntersectionOptions options;
    options.tolerances.point = tolerance;
    const SurfaceIntersection found = intersect(GetParam().a, GetParam().b, options);
    ASSERT_FALSE(found.curves.empty());
    for (const IntersectionCurve& curve : found.curves) {
      const Deviation& d = curve.deviation;
      EXPECT_LE(std::max({d.a, d.b, d.between}), tolerance) << curve.curve.points.size();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Pairs, FitOf, ::testing::ValuesIn(surface_pairs()),
                         [](const auto& test) { return test.param.name; });

// The knot of a surface becomes a knot of the curve, as smooth as the surface is there.
TEST(Fit, HasAKnotOfTheRightMultiplicityWhereTheSurfaceHasOne) {
  for (const auto& [name, multiplicity] :
       {std::pair{"third_derivative_jumps", 3}, {"curvature_jumps", 4}, {"crease", 5}}) {
    const auto pairs = surface_pairs();
    const auto& pair = *std::find_if(pairs.begin(), pairs.end(),
                                     [&](const SurfacePair& p) { return p.name == name; });
    const SurfaceIntersection found = intersect(pair.a, pair.b);
    ASSERT_EQ(found.curves.size(), 1u) << name;
    const Spline& curve = found.curves[0].curve;
    const auto on_knot_line = [&](double knot) {
      return std::abs(point_at(curve, knot)[0] - 0.4) < 1e-9;
    };
    int at_knot = on_knot_line(curve.knots.front()) ? 1 : 0;  // a loop may begin there
    for (std::size_t i = 1; i + 1 < curve.knots.size(); ++i) {
      const bool there = on_knot_line(curve.knots[i]);
      EXPECT_EQ(curve.multiplicities[i], there ? multiplicity : 1) << name;
      at_knot += there;
    }
    EXPECT_EQ(at_knot, 2) << name;
  }
}

// A blend runs into a plane that is all but tangent to it along its border. The branch comes in
// across the border and turns along it within a millionth of the blend's length. (Faces 42 and 189
// of Open CASCADE's sample bearing.iges.)
TEST(Fit, OfABranchThatTurnsSharplyBehindABorderIsFound) {
  const BezierSurface blend =
      testing::of_patch(patch_of(4, {{-0.01817654, 0.0163104, 0.01561499},
                                     {-0.0180679, 0.01609269, 0.01444051},
                                     {-0.01877193, 0.01523487, 0.01358498},
                                     {-0.01968022, 0.01447823, 0.01378772},
                                     {-0.01962434, 0.01793196, 0.01518049},
                                     {-0.0195157, 0.01771425, 0.01400601},
                                     {-0.02021973, 0.01685643, 0.01315048},
                                     {-0.02112802, 0.01609979, 0.01335322},
                                     {-0.02107213, 0.01955352, 0.01474599},
                                     {-0.0209635, 0.01933581, 0.01357151},
                                     {-0.02166753, 0.01847799, 0.01271598},
                                     {-0.02257582, 0.01772135, 0.01291872},
                                     {-0.02251993, 0.02117508, 0.0143115},
                                     {-0.02241129, 0.02095737, 0.01313702},
                                     {-0.02311532, 0.02009955, 0.01228149},
                                     {-0.02402361, 0.01934291, 0.01248423}}));
  const BezierSurface plane =
      testing::of_patch(patch_of(2, {{-0.01967537874, 0.01447112718, 0.01378961924},
                                     {-0.03361436509, 0.01447112718, 0.01378961924},
                                     {-0.01967537874, 0.02475166167, 0.01103495648},
                                     {-0.03361436509, 0.02475166167, 0.01103495648}}));

  const SurfaceIntersection found = intersect(blend, plane);

  EXPECT_NE(found.status, Status::Stopped);
  ASSERT_EQ(found.curves.size(), 1u);
  EXPECT_NEAR(found.curves[0].length, 0.0032846, 1e-7);
  EXPECT_LT(found.curves[0].deviation.a, 1e-7);
}

}  // namespace
}  // namespace blossom
