// SPDX-License-Identifier: LGPL-2.1-or-later
// Bounds on the distance of facets, beside the largest distance of many samples.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/math/index.h"
#include "core/tessellation/chart_surface.h"
#include "core/tessellation/charts/elementary_chart.h"
#include "core/tessellation/charts/jet_enclosure.h"
#include "core/tessellation/charts/spline_chart.h"
#include "tests/support/random.h"
#include "tests/support/shapes.h"
#include "tests/support/solids.h"

namespace blossom {
namespace {

using testing::random_patch;
using testing::seeded;
using testing::uniform;

constexpr int kSamples = 24;  // along a side
constexpr double kRounding = 1e-12;
// Where a surface bends to both sides its second derivatives are larger than what they come to.
constexpr double kNearlyFlat = 0.004;

double height(const ElementaryChart& chart, const Vec3& p) {
  const Vec3 off = p - chart.origin;
  const double along = dot(off, chart.z), across = norm(off - along * chart.z);
  switch (chart.kind) {
    case ElementaryKind::Plane: return std::abs(along);
    case ElementaryKind::Cylinder: return std::abs(across - chart.radius);
    case ElementaryKind::Cone:
      return std::abs((across - chart.radius) * std::cos(chart.angle) -
                      along * std::sin(chart.angle));
    case ElementaryKind::Sphere: return std::abs(norm(off) - chart.radius);
    case ElementaryKind::Torus:
      return std::abs(std::hypot(across - chart.radius, along) - chart.minor);
  }
  return 0;
}

// Calls `visit` at points of the facet, by shares of its corners.
void for_samples(const auto& visit) {
  for (int i = 0; i <= kSamples; ++i)
    for (int j = 0; i + j <= kSamples; ++j)
      visit(static_cast<double>(i) / kSamples, static_cast<double>(j) / kSamples);
}

double sampled_height(const ElementaryChart& chart, const std::array<Vec2, 3>& corners) {
  std::array<Vec3, 3> p;
  for (std::size_t k = 0; k < 3; ++k) p[k] = frame_at(chart, corners[k]).point;
  double most = 0;
  for_samples([&](double s, double t) {
    most = std::max(most, height(chart, p[0] + s * (p[1] - p[0]) + t * (p[2] - p[0])));
  });
  return most;
}

class FacetDistance : public ::testing::TestWithParam<ElementaryKind> {};

TEST_P(FacetDistance, IsNeverBelowASampledOneAndNotFarAboveIt) {
  auto random = seeded(static_cast<int>(GetParam()));
  for (int trial = 0; trial < 300; ++trial) {
    ElementaryChart chart{.kind = GetParam()};
    chart.origin = {uniform(random, -5, 5), uniform(random, -5, 5), uniform(random, -5, 5)};
    chart.radius = uniform(random, 4, 9);
    chart.minor = uniform(random, 0.5, 1.5);
    chart.angle = uniform(random, -1, 1);
    const double v = GetParam() == ElementaryKind::Sphere  ? uniform(random, -1, 1)
                     : GetParam() == ElementaryKind::Torus ? uniform(random, -3, 3)
                                                           : uniform(random, 0, 1);
    const Vec2 first{uniform(random, 0, 6), v};
    std::array<Vec2, 3> corners{first, first, first};
    for (std::size_t k = 1; k < 3; ++k)
      corners[k] += Vec2{uniform(random, -0.06, 0.06), uniform(random, -0.06, 0.06)};
    const double bound = facet_distance(chart, corners), sampled = sampled_height(chart, corners);
    EXPECT_LE(sampled, bound + kRounding);
    EXPECT_LE(bound, 3 * sampled + kNearlyFlat);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, FacetDistance,
                         ::testing::Values(ElementaryKind::Plane, ElementaryKind::Cylinder,
                                           ElementaryKind::Cone, ElementaryKind::Sphere,
                                           ElementaryKind::Torus));

TEST(FacetDistanceOf, ACylinderIsTheHeightOfTheArc) {
  const ElementaryChart chart{.kind = ElementaryKind::Cylinder, .radius = 2};
  const double quarter = std::numbers::pi / 2;
  EXPECT_NEAR(facet_distance(chart, {Vec2{0, 0}, Vec2{quarter, 0}, Vec2{0, 7}}),
              2 * (1 - std::sqrt(0.5)), 1e-15);
}

// By second derivatives bounds are farther above: they count what moves points within the surface.
TEST(FacetDistanceOf, ATorusIsNearTheTruthForLargeFacets) {
  auto random = seeded(21);
  const ElementaryChart chart{.kind = ElementaryKind::Torus, .radius = 12, .minor = 4};
  for (int trial = 0; trial < 500; ++trial) {
    const double u = uniform(random, 0, 6), v = uniform(random, -3, 3);
    const double w = uniform(random, 0.1, 0.4), h = uniform(random, 0.2, 0.6);
    const std::array corners{Vec2{u, v}, Vec2{u + w, v}, Vec2{u + w / 2, v + h}};
    const double bound = facet_distance(chart, corners), sampled = sampled_height(chart, corners);
    EXPECT_LE(sampled, bound + kRounding);
    EXPECT_LE(bound, 3.5 * sampled) << u << ' ' << v << ' ' << w << ' ' << h;
  }
}

// Corners on a line up to rounding: as along a seam, where a fine mesh has many of them.
TEST(FacetDistanceOf, ANeedleOnASphereIsTheHeightOfItsLongestSide) {
  auto random = seeded(11);
  const ElementaryChart chart{.kind = ElementaryKind::Sphere, .radius = 12};
  for (int trial = 0; trial < 2000; ++trial) {
    const double u = uniform(random, 0, 6), v = uniform(random, -1.5, 1.5);
    const double side = uniform(random, 1e-4, 1e-2);
    const double thin = std::pow(10, uniform(random, -17, -10));
    const std::array corners{Vec2{u, v}, Vec2{u + uniform(random, -1, 1) * thin, v + side},
                             Vec2{u, v + uniform(random, 0.1, 0.9) * side}};
    const double height = chart.radius * (1 - std::cos(side / 2));
    EXPECT_NEAR(facet_distance(chart, corners), height, 1e-6 * height + kRounding);
  }
}

TEST(FacetDistanceOf, AParaboloidIsKnownByHand) {
  // z = (u^2 + v^2) / 2 over a right triangle with legs 1: the circle through its corners has the
  // radius sqrt(1/2), so that the largest height is 1/4.
  JetEnclosure jet;
  jet.uu.centre = jet.vv.centre = {0, 0, 1};
  EXPECT_DOUBLE_EQ(facet_distance(jet, {0, 0, 1}, {Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}}), 0.25);
}

TEST(LargestMean, IsTheSquareOfTheRadiusOrAQuarterOfTheLongestSide) {
  EXPECT_DOUBLE_EQ(largest_mean(3, 3, 3), 1);  // equilateral: 3 / 3
  EXPECT_DOUBLE_EQ(largest_mean(9, 16, 25), 25.0 / 4);
  EXPECT_DOUBLE_EQ(largest_mean(1, 1, 4), 1);  // on a line
  EXPECT_DOUBLE_EQ(largest_mean(-5, 0, 4), 1);
}

TEST(LargestMean, OfNeedlesIsNoLargerThanOfAnEquilateralTriangleOfTheLongestSide) {
  auto random = seeded(12);
  for (int trial = 0; trial < 20000; ++trial) {
    const double c = std::pow(10, uniform(random, -20, 0));
    const double mean = largest_mean(1, 1 - uniform(random, 0, 1) * c, c);
    EXPECT_LE(mean, 1.0 / 3);
    EXPECT_GE(mean, 0.25 - 1e-15);
  }
}

// The distance of facets from a surface that is a graph is at most the height over it.
TEST(SplineChart, BoundsTheHeightsOfRandomGraphs) {
  auto random = seeded(7);
  for (int trial = 0; trial < 60; ++trial) {
    RationalBezierPatch patch{Grid<Vec4>(4, 3)};
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 3; ++j)
        patch.points(i, j) = {i / 3.0, j / 2.0, uniform(random, -0.3, 0.3), 1};
    const BezierSurface surface = testing::one_patch(patch);
    const SplineChart chart(surface, 1e-3);
    std::array<Vec2, 3> corners;
    const Vec2 first{uniform(random, 0, 0.8), uniform(random, 0, 0.8)};
    for (Vec2& corner : corners)
      corner = first + Vec2{uniform(random, 0, 0.2), uniform(random, 0, 0.2)};
    std::array<Vec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = chart.frame_at(corners[k]).point;
    const Vec3 n = chart.frame_at(corners[0]).normal;
    double along = 0;
    for_samples([&](double s, double t) {
      const Vec3 on_facet = p[0] + s * (p[1] - p[0]) + t * (p[2] - p[0]);
      const Vec2 uv = corners[0] + s * (corners[1] - corners[0]) + t * (corners[2] - corners[0]);
      along = std::max(along, std::abs(dot(n, chart.frame_at(uv).point - on_facet)));
    });
    const double bound = chart.facet_distance(corners, n, 0);
    EXPECT_LE(along, bound + kRounding);
    EXPECT_LE(bound, 3 * along + kNearlyFlat);
  }
}

TEST(SplineChart, KnowsThatArcsOfOneSphereGoOnSmoothly) {
  const SplineChart chart(testing::unit_sphere(), 1e-3);
  // Over a line between patches; with a jump of S_u the bound would be of the size of the facet.
  const double turn = std::numbers::pi / 2;
  const std::array corners{Vec2{turn - 0.05, 0}, Vec2{turn + 0.05, 0}, Vec2{turn, 0.1}};
  const double bound = chart.facet_distance(corners, chart.frame_at({turn, 0}).normal, 0);
  EXPECT_GE(bound, 1 - std::cos(0.05));
  EXPECT_LE(bound, 3 * (1 - std::cos(0.06)));
}

TEST(SplineChart, CountsAKinkBetweenPatches) {
  BezierSurface surface;
  surface.u_knots = {0, 1, 2};
  surface.v_knots = {0, 1};
  surface.patches = Grid<RationalBezierPatch>(2, 1);
  surface.patches(0, 0) =
      testing::quadrilateral({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}).patches(0, 0);
  surface.patches(1, 0) =
      testing::quadrilateral({1, 0, 0}, {1, 1, 0}, {1, 0, 1}, {1, 1, 1}).patches(0, 0);
  const SplineChart chart(surface, 1e-3);
  // A roof from (0, 0, 0) over (1, 0, 0) to (1, 0, 1): the chord is sqrt(1/2) from the ridge.
  const std::array corners{Vec2{0, 0}, Vec2{2, 0}, Vec2{2, 0.5}};
  EXPECT_GE(chart.facet_distance(corners, chart.frame_at({0.5, 0}).normal, 0), std::sqrt(0.5) / 2);
  EXPECT_NEAR(chart.facet_distance({Vec2{0, 0}, Vec2{1, 0}, Vec2{1, 1}},
                                   chart.frame_at({0.5, 0}).normal, 0),
              0, 1e-15);
}

// A strip z = f(u), straight along v, whose second derivative changes from -bend to bend.
BezierSurface wave(double bend) {
  RationalBezierPatch patch{Grid<Vec4>(4, 2)};
  const std::array<double, 4> heights{0, bend / 18, -bend / 18, 0};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 2; ++j) patch.points(i, j) = {i / 3.0, double(j), heights[index(i)], 1};
  return testing::one_patch(patch);
}

// A chord over 1 / n of it is off by bend / (8 n^2) at most.
TEST(SplineChart, HasNoMoreCellsThanFacets) {
  constexpr double kFine = 1e-3;
  for (const double facets : {0.5, 0.9, 1.5, 1.9, 2.5, 3.5, 6.5}) {
    const SplineChart chart(wave(8 * kFine * facets * facets), kFine);
    EXPECT_LE(chart.u_cells().size() - 1, std::ceil(facets)) << facets;
    EXPECT_EQ(chart.v_cells().size() - 1, 1u) << facets;
  }
}

TEST(ChartSurface, RoughDistanceIsNeverBelowTheBound) {
  auto random = seeded(8);
  int above = 0;
  for (int trial = 0; trial < 200; ++trial) {
    RationalBezierPatch patch{Grid<Vec4>(4, 4)};
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        patch.points(i, j) = {i / 3.0, j / 3.0, uniform(random, -0.3, 0.3), 1};
    const ChartSurface surface(testing::one_patch(patch), {.deviation = 1e-2});
    std::array<Vec2, 3> corners;
    for (Vec2& corner : corners) corner = {uniform(random, 0, 1), uniform(random, 0, 1)};
    const Vec3 n = surface.frame_at(corners[0]).normal;
    const double bound = surface.facet_distance(corners, n);
    const double rough = surface.rough_distance(corners, n);
    EXPECT_GE(rough, bound);
    above += rough > bound;
  }
  EXPECT_GT(above, 0);  // and is another one
}

}  // namespace
}  // namespace blossom
