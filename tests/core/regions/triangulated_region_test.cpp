// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/regions/triangulated_region.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/errors.h"
#include "tests/support/random.h"
#include "tests/support/region_checks.h"

namespace blossom {
namespace {

using testing::Chart;
using testing::expect_on_surface;
using testing::expect_whole_sides;
using testing::grid_area;
using testing::heights;
using testing::kPi;
using testing::seeded;
using testing::uniform;
using testing::whole;

// A quarter of the cylinder of radius 2: the first parameter is an angle.
BezierSurface quarter_cylinder() {
  BezierSurface surface;
  surface.u_knots = {0, kPi / 2};
  surface.v_knots = {0, 1};
  surface.u_law = ParameterLaw::Angle;
  surface.rational = true;
  surface.patches = Grid<RationalBezierPatch>(1, 1);
  RationalBezierPatch& patch = surface.patches(0, 0);
  patch.points = Grid<Vec4>(3, 2);
  const double w = std::sqrt(0.5);
  for (int b = 0; b < 2; ++b) {
    patch.points(0, b) = {2, 0, 3.0 * b, 1};
    patch.points(1, b) = {2 * w, 2 * w, 3.0 * b * w, w};
    patch.points(2, b) = {0, 2, 3.0 * b, 1};
  }
  return surface;
}

bool all_exact(const TriangulatedRegion& region) {
  return std::ranges::all_of(region.pieces, [](const RegionPiece& piece) { return piece.exact; });
}

std::size_t cell_count(const TriangulatedRegion& region) {
  return static_cast<std::size_t>(std::ranges::count_if(
      region.pieces,
      [](const RegionPiece& piece) { return std::holds_alternative<RegionCell>(piece.shape); }));
}

TEST(TriangulatedRegion, OfAWholePatchIsItsCells) {
  const BezierSurface surface = heights({0, 1}, {0, 1}, 3);

  const TriangulatedRegion region = triangulated_region(surface, whole(1, 1).made);

  ASSERT_TRUE(region.obstacle.empty());
  EXPECT_EQ(region.pieces.size(), 16u);
  EXPECT_EQ(cell_count(region), 16u);
  EXPECT_TRUE(all_exact(region));
  expect_whole_sides(region);
}

TEST(TriangulatedRegion, RoundAHoleHasExactTrianglesAndCells) {
  const BezierSurface surface = heights({0, 1}, {0, 1}, 3);

  const TriangulatedRegion region =
      triangulated_region(surface, whole(1, 1).circle({0.5, 0.5}, 0.25).made);

  ASSERT_TRUE(region.obstacle.empty()) << region.obstacle;
  EXPECT_EQ(cell_count(region), 4u);
  EXPECT_TRUE(all_exact(region));
  EXPECT_NEAR(grid_area(region), 1 - kPi / 16, 1e-14);
  expect_whole_sides(region);
  expect_on_surface(surface, region, 1e-14);
  for (const RegionPiece& piece : region.pieces)
    if (const auto* triangle = std::get_if<CurvedTriangle>(&piece.shape)) {
      const bool curved = triangle->map.degree > 1;
      EXPECT_EQ(std::get<RationalBezierTriangle>(bezier_form(surface, piece)).degree,
                curved ? 12 : 6);
    }
}

TEST(TriangulatedRegion, CrossesLinesBetweenPatchesAndTouchesThem) {
  const BezierSurface surface = heights({0, 0.3, 0.7, 1.5}, {0, 0.5, 1, 1.2, 2}, 2);
  // The first circle touches u = 0.3 and crosses v = 0.5, the second runs round a corner of
  // patches.
  Chart chart = whole(1.5, 2).circle({0.5, 0.5}, 0.2).circle({0.7, 1.2}, 0.15);

  const TriangulatedRegion region = triangulated_region(surface, chart.made);

  ASSERT_TRUE(region.obstacle.empty()) << region.obstacle;
  EXPECT_TRUE(all_exact(region));
  expect_whole_sides(region);
  expect_on_surface(surface, region, 1e-14);
  double area = 0;
  for (const RegionPiece& piece : region.pieces) {
    const PatchChart place = chart_of(surface, piece.patch_u, piece.patch_v);
    area += grid_area(piece) * length(place.u) * length(place.v);
  }
  EXPECT_NEAR(area, 3 - kPi * (0.04 + 0.0225), 1e-13);
}

TEST(TriangulatedRegion, TakesTrimsThatReachALittleBeyondThePatches) {
  const BezierSurface surface = heights({0, 0.5, 1}, {0, 0.5, 1}, 2);
  const double e = 1e-6;
  const Chart chart = Chart().polygon({{-e, -e}, {1 + e, -e}, {1 + e, 1 + e}, {-e, 1 + e}});

  const TriangulatedRegion region = triangulated_region(surface, chart.made);

  ASSERT_TRUE(region.obstacle.empty()) << region.obstacle;
  EXPECT_NEAR(grid_area(region), 4 * (1 + 2 * e) * (1 + 2 * e), 1e-13);
  expect_whole_sides(region);
}

// x = u^8, which is ten times as steep at u = 1.4 as anywhere in the patch.
TEST(TriangulatedRegion, BoundsArcsBeyondThePatchesByWhatTheSurfaceDoesThere) {
  BezierSurface surface = heights({0, 1}, {0, 1}, 1);
  RationalBezierPatch& patch = surface.patches(0, 0);
  patch.points = Grid<Vec4>(9, 2);
  for (int i = 0; i <= 8; ++i)
    for (int j = 0; j < 2; ++j) patch.points(i, j) = {i == 8 ? 1.0 : 0.0, 1.0 * j, 0, 1};
  const PlanarBezier quartic{
      {{1.4, 0.1, 1}, {1.5, 0.3, 1}, {1.2, 0.5, 1}, {1.5, 0.7, 1}, {1.4, 0.9, 1}}};
  const Chart chart = Chart().loop({{{{0.2, 0.1, 1}, {1.4, 0.1, 1}}},
                                    quartic,
                                    {{{1.4, 0.9, 1}, {0.2, 0.9, 1}}},
                                    {{{0.2, 0.9, 1}, {0.2, 0.1, 1}}}});
  RegionOptions options;
  options.tolerance = 1e-3;

  const TriangulatedRegion region = triangulated_region(surface, chart.made, options);

  ASSERT_TRUE(region.obstacle.empty()) << region.obstacle;
  double most = 0;
  for (const RegionArc& arc : region.arcs) {
    const PlanarCurve& border = chart.made.borders[static_cast<std::size_t>(arc.border)].curve;
    for (int k = 1; k < 16; ++k) {
      const Vec2 p = jet_at(arc.curve, k / 16.0).point,
                 q = point_at(border, at(arc.place, k / 16.0));
      const double gap = distance(point_at(patch, p[0], p[1]), point_at(patch, q[0], q[1]));
      most = std::max(most, gap);
      EXPECT_LE(gap, arc.error + 1e-12);
    }
    EXPECT_LE(arc.fit_error, options.tolerance);
  }
  EXPECT_GT(most, 1e-5);
}

TEST(TriangulatedRegion, TakesACuspBetweenArcsThatTouch) {
  const BezierSurface surface = heights({0, 1}, {0, 1}, 3);
  // Between v = 0.2 and v = 0.2 + (u - 0.1)^2, closed by u = 0.9.
  const Chart chart = Chart().loop({{{{0.1, 0.2, 1}, {0.9, 0.2, 1}}},
                                    {{{0.9, 0.2, 1}, {0.9, 0.84, 1}}},
                                    {{{0.9, 0.84, 1}, {0.5, 0.2, 1}, {0.1, 0.2, 1}}}});

  const TriangulatedRegion region = triangulated_region(surface, chart.made);

  ASSERT_TRUE(region.obstacle.empty()) << region.obstacle;
  EXPECT_TRUE(all_exact(region));
  EXPECT_NEAR(grid_area(region), 0.512 / 3, 1e-14);
  expect_whole_sides(region);
}

TEST(TriangulatedRegion, FitsArcsWhoseDegreeIsTooHighWithinTheTolerance) {
  const BezierSurface surface = heights({0, 1}, {0, 1}, 4);
  const std::vector<Vec3> quintic{{0.9, 0.5, 1}, {0.8, 1.1, 1}, {0.6, 0.2, 1},
                                  {0.4, 1.2, 1}, {0.2, 0.7, 1}, {0.1, 0.5, 1}};
  const Chart chart = Chart().loop({{{{0.1, 0.5, 1}, {0.5, 0, 1}, {0.9, 0.5, 1}}}, {quintic}});
  RegionOptions options;
  options.tolerance = 1e-6;

  const TriangulatedRegion region = triangulated_region(surface, chart.made, options);

  ASSERT_TRUE(region.obstacle.empty()) << region.obstacle;
  EXPECT_FALSE(all_exact(region));
  expect_whole_sides(region);
  expect_on_surface(surface, region, 0.1 * options.tolerance);
  for (const RegionPiece& piece : region.pieces) EXPECT_LE(piece.error, options.tolerance);
  for (const RegionArc& arc : region.arcs) {
    EXPECT_EQ(arc.exact, arc.border == 0);
    EXPECT_LE(arc.error, 1e-6);
    for (const double t : {0.2, 0.5, 0.8}) {
      const Vec2 p = jet_at(arc.curve, t).point;
      const Vec2 q = point_at(chart.made.borders[static_cast<std::size_t>(arc.border)].curve,
                              at(arc.place, t));
      EXPECT_LE(distance(point_at(surface, p), point_at(surface, q)), arc.error + 1e-14);
    }
  }
}

// Only straight arcs have triangles within degree 25 here, and would be more than 5000.
TEST(TriangulatedRegion, LowersTrianglesOverCubicArcsOnPatchesOfHighDegree) {
  const BezierSurface surface = heights({0, 1}, {0, 1}, 7);
  RegionOptions options;
  options.tolerance = 1e-8;

  const TriangulatedRegion region =
      triangulated_region(surface, whole(1, 1).circle({0.5, 0.5}, 0.3).made, options);

  ASSERT_TRUE(region.obstacle.empty()) << region.obstacle;
  EXPECT_LT(region.pieces.size(), 1000u);
  expect_whole_sides(region);
  expect_on_surface(surface, region, options.tolerance);
  double most = 0;
  for (const RegionPiece& piece : region.pieces) {
    EXPECT_LE(piece.error, 2 * options.tolerance);
    most = std::max(most, piece.off_surface);
    const RegionForm form = bezier_form(surface, piece);
    if (const auto* made = std::get_if<RationalBezierTriangle>(&form)) {
      EXPECT_LE(made->degree, kMaxDegree);
      EXPECT_EQ(piece.exact, std::get<CurvedTriangle>(piece.shape).map.degree == 1);
    }
  }
  EXPECT_GT(most, 0);
  EXPECT_LE(most, options.tolerance);
  for (const RegionArc& arc : region.arcs)
    for (const double t : {0.2, 0.5, 0.8}) {
      const double radius = distance(jet_at(arc.curve, t).point, Vec2{0.5, 0.5});
      EXPECT_NEAR(arc.border == 4 ? radius : 0.3, 0.3, options.tolerance);
    }
}

// Their weights are lowered with them; straight arcs within degree 25 would be about 1000.
TEST(TriangulatedRegion, LowersTrianglesOnRationalPatchesOfHighDegree) {
  BezierSurface surface = heights({0, 1}, {0, 1}, 7);
  surface.rational = true;
  for (Vec4& p : surface.patches(0, 0).points.values()) p = (1 + 0.5 * p[0] * p[0]) * p;
  RegionOptions options;
  options.tolerance = 1e-7;

  const TriangulatedRegion region =
      triangulated_region(surface, whole(1, 1).circle({0.5, 0.5}, 0.3).made, options);

  ASSERT_TRUE(region.obstacle.empty()) << region.obstacle;
  EXPECT_LT(region.pieces.size(), 300u);
  expect_whole_sides(region);
  double most = 0;
  for (const RegionPiece& piece : region.pieces) {
    EXPECT_LE(piece.error, 2 * options.tolerance);
    most = std::max(most, piece.off_surface);
  }
  EXPECT_GT(most, 0);
  EXPECT_LE(most, options.tolerance);
  expect_on_surface(surface, region, most);
}

TEST(TriangulatedRegion, OfACylinderFollowsItsAngles) {
  const BezierSurface surface = quarter_cylinder();
  Chart chart = whole(kPi / 2, 1).circle({0.8, 0.5}, 0.3);

  const TriangulatedRegion region = triangulated_region(surface, chart.made);

  ASSERT_TRUE(region.obstacle.empty()) << region.obstacle;
  EXPECT_GT(cell_count(region), 0u);
  expect_whole_sides(region);
  expect_on_surface(surface, region, 1e-8);
  for (const RegionPiece& piece : region.pieces) EXPECT_LE(piece.error, 1e-7);
  for (const RegionArc& arc : region.arcs) {
    EXPECT_EQ(arc.exact, arc.border < 4);
    EXPECT_LE(arc.error, 1e-7);
    for (const double t : {0.3, 0.6}) {
      const Vec2 local = jet_at(arc.curve, t).point;
      const double angle = parameter_at(surface.u_law, {0, kPi / 2}, local[0]);
      const double radius = distance(Vec2{angle, local[1]}, Vec2{0.8, 0.5});
      EXPECT_NEAR(arc.border == 4 ? radius : 0.3, 0.3, 1e-7);
    }
  }
}

TEST(TriangulatedRegion, IsDividedWhereItIsTold) {
  const BezierSurface surface = heights({0, 1}, {0, 1}, 3);
  Chart chart = whole(1, 1).circle({0.5, 0.5}, 0.3);
  chart.made.borders[4].stops = {0.1, 2.5, 6};

  const TriangulatedRegion region = triangulated_region(surface, chart.made);

  ASSERT_TRUE(region.obstacle.empty());
  for (const double stop : {0.1, 2.5, 6.0}) EXPECT_TRUE(std::ranges::count(region.stops[4], stop));
}

TEST(TriangulatedRegion, SaysWhyThereIsNone) {
  const BezierSurface surface = heights({0, 1}, {0, 1}, 3);

  // Two holes that cross, and a loop that runs the wrong way.
  EXPECT_FALSE(triangulated_region(surface, whole(1, 1)
                                                .polygon({{0.2, 0.2}, {0.2, 0.6}, {0.6, 0.2}})
                                                .polygon({{0.3, 0.1}, {0.3, 0.7}, {0.7, 0.7}})
                                                .made)
                   .obstacle.empty());
}

TEST(TriangulatedRegion, RefusesWhatIsNoChart) {
  const BezierSurface surface = heights({0, 1}, {0, 1}, 3);
  TrimmedChart chart = whole(1, 1).made;
  chart.borders[0].to = 7;
  EXPECT_THROW(triangulated_region(surface, chart), InvalidInput);
  RegionOptions options;
  options.highest_degree = 5;
  EXPECT_THROW(triangulated_region(surface, whole(1, 1).made, options), InvalidInput);
  options = {};
  options.tolerance = 0;
  EXPECT_THROW(triangulated_region(surface, whole(1, 1).made, options), InvalidInput);
}

// Random smooth loops over random grids of patches: areas add up, sides are whole.
class TriangulatedRegionProperty : public ::testing::TestWithParam<int> {};

TEST_P(TriangulatedRegionProperty, CoversTheRegionOnce) {
  auto random = seeded(GetParam());
  std::vector<double> u{0, 1}, v{0, 1};
  for (int k = GetParam() % 4; k > 0; --k) u.push_back(uniform(random, 0.05, 0.95));
  for (int k = GetParam() / 4 % 4; k > 0; --k) v.push_back(uniform(random, 0.05, 0.95));
  std::ranges::sort(u);
  std::ranges::sort(v);
  const BezierSurface surface = heights(u, v, 1 + GetParam() % 3);
  // A closed cubic spline round the middle, as Bezier curves that join smoothly.
  const int count = 5 + static_cast<int>(random() % 8);
  std::vector<Vec2> nodes;
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * kPi * k / count, r = uniform(random, 0.15, 0.45);
    nodes.push_back({0.5 + r * std::cos(angle), 0.5 + r * std::sin(angle)});
  }
  const auto node = [&](int k) { return nodes[static_cast<std::size_t>((k + count) % count)]; };
  std::vector<PlanarBezier> curves;
  for (int k = 0; k < count; ++k) {
    const Vec2 from = node(k), to = node(k + 1);
    const Vec2 a = from + (1.0 / 8) * (to - node(k - 1)), b = to - (1.0 / 8) * (node(k + 2) - from);
    curves.push_back(
        {{{from[0], from[1], 1}, {a[0], a[1], 1}, {b[0], b[1], 1}, {to[0], to[1], 1}}});
  }
  const double expected = area_along(curves, {0.5, 0.5});

  const TriangulatedRegion region = triangulated_region(surface, Chart().loop(curves).made);

  ASSERT_TRUE(region.obstacle.empty()) << region.obstacle;
  EXPECT_TRUE(all_exact(region));
  expect_whole_sides(region);
  double area = 0;
  for (const RegionPiece& piece : region.pieces) {
    const PatchChart place = chart_of(surface, piece.patch_u, piece.patch_v);
    area += grid_area(piece) * length(place.u) * length(place.v);
  }
  EXPECT_NEAR(area, expected, 1e-13);
}

INSTANTIATE_TEST_SUITE_P(Seeds, TriangulatedRegionProperty, ::testing::Range(0, 64));

}  // namespace
}  // namespace blossom
