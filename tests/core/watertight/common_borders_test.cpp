// SPDX-License-Identifier: LGPL-2.1-or-later
// Regions whose borders are common with other faces.
#include "core/regions/triangulated_region.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/region_checks.h"

namespace blossom {
namespace {

using testing::Chart;
using testing::expect_on_surface;
using testing::expect_whole_sides;
using testing::grid_area;
using testing::heights;
using testing::whole;

// With common borders; no obstacle, and no side ends in the middle of another.
TriangulatedRegion whole_region(const BezierSurface& surface, const Chart& chart,
                                RegionOptions options = {}) {
  options.common_borders = true;
  TriangulatedRegion region = triangulated_region(surface, chart.made, options);
  EXPECT_TRUE(region.obstacle.empty()) << region.obstacle;
  expect_whole_sides(region);
  return region;
}

RegionOptions within(double tolerance) {
  RegionOptions options;
  options.tolerance = tolerance;
  return options;
}

void expect_no_short_arcs(const TriangulatedRegion& region) {
  for (const RegionArc& arc : region.arcs) {
    const Vec2 way = region.vertices[static_cast<std::size_t>(arc.to)] -
                     region.vertices[static_cast<std::size_t>(arc.from)];
    EXPECT_GT(norm(way), 1e-3);
  }
}

// Two patches that meet at u = 0.5 and have a pole at v = 0.
BezierSurface fan() {
  BezierSurface surface = heights({0, 0.5, 1}, {0, 1}, 1);
  for (int i = 0; i < 2; ++i)
    for (int a = 0; a < 2; ++a) surface.patches(i, 0).points(a, 0) = {0.5, 0, 0, 1};
  return surface;
}

// A patch with a pole at v = 0, where the corner with (1, 0) lies, and the corner across given.
BezierSurface sector(const Vec2& far) {
  BezierSurface surface = heights({0, 1}, {0, 1}, 1);
  RationalBezierPatch& patch = surface.patches(0, 0);
  patch.points(0, 0) = patch.points(1, 0) = {0, 0, 0, 1};
  patch.points(0, 1) = {1, 0, 0, 1};
  patch.points(1, 1) = {far[0], far[1], 0, 1};
  return surface;
}

// All of a sector, with 15 stops on one ruling.
Chart chart_of_sector() {
  Chart chart = whole(1, 1);
  chart.made.borders[0].is_point = true;
  for (int k = 1; k < 16; ++k) chart.made.borders[3].stops.push_back(k / 16.0);
  return chart;
}

// With common borders the arcs run as evenly as the angle of the circle does.
TEST(CommonBorders, KeepsParametersForCommonBorders) {
  const BezierSurface surface = heights({0, 1}, {0, 1}, 3);
  Chart chart = whole(1, 1).circle({0.5, 0.5}, 0.3);
  const TriangulatedRegion region = whole_region(surface, chart, within(1e-8));

  EXPECT_GE(region.arcs.size(), chart.made.borders.size());
  for (const RegionArc& arc : region.arcs) {
    EXPECT_LE(arc.error, 1e-8);
    for (const double t : {0.25, 0.5, 0.9}) {
      const Vec2 wanted = point_at(chart.made.borders[static_cast<std::size_t>(arc.border)].curve,
                                   at(arc.place, t));
      EXPECT_LE(distance(jet_at(arc.curve, t).point, wanted), 1e-8);
    }
  }
}

// The lower corner in the middle is 3e-8 beside u = 0.5, the upper one on it, and a stop of another
// face is 3e-8 beside where the slanting side crosses v = 0.5.
TEST(CommonBorders, TakesCrossingsOfCommonBordersToStopsBesideThem) {
  const BezierSurface surface = heights({0, 0.5, 1}, {0, 0.5, 1}, 3);
  Chart chart = Chart().polygon(
      {{0.1, 0.1}, {0.5 - 3e-8, 0.2}, {0.9, 0.1}, {0.7, 0.9}, {0.5, 0.8}, {0.3, 0.9}});
  chart.made.borders[2].stops = {0.5 + 3e-8};
  const TriangulatedRegion region = whole_region(surface, chart, within(1e-6));

  expect_on_surface(surface, region, 1e-14);
  expect_no_short_arcs(region);
  EXPECT_TRUE(std::ranges::count(region.stops[2], 0.5 + 3e-8));
  EXPECT_GT(region.beyond_lines, 2e-8);
  EXPECT_LT(region.beyond_lines, 1e-6);

  // Borders of one face alone stay where they are.
  EXPECT_EQ(triangulated_region(surface, chart.made, within(1e-6)).beyond_lines, 0);
}

// The border along the line u = 0.5 leaves it by 1e-6 there, which is 6e-8 in
// space at most, and ends beside it.
TEST(CommonBorders, RunAlongALineThatTheyLeaveInTheChartAlone) {
  const BezierSurface surface = fan();
  Chart chart = Chart().loop({{{{0.5 + 1e-6, 0, 1}, {0.5, 0, 1}, {0.5, 1, 1}}},
                              {{{0.5, 1, 1}, {0, 1, 1}}},
                              {{{0, 1, 1}, {0, 0, 1}}},
                              {{{0, 0, 1}, {0.5 + 1e-6, 0, 1}}}});
  chart.made.borders[0].stops = {0.1, 0.7};
  chart.made.borders[3].is_point = true;
  const TriangulatedRegion region = whole_region(surface, chart, within(3e-7));

  EXPECT_FALSE(region.pieces.empty());
  for (const RegionPiece& piece : region.pieces) EXPECT_EQ(piece.patch_u, 0);
  EXPECT_GT(std::ranges::count(region.arcs, 0, &RegionArc::border), 0);
  for (const RegionArc& arc : region.arcs) {
    EXPECT_EQ(arc.patch_u, 0);
    if (arc.border != 0) continue;
    EXPECT_EQ(region.vertices[static_cast<std::size_t>(arc.to)][0], 1);
  }
}

// The pole is so near to the lower left corner that the crossing of u = 0.5 beside it is 1e-8
// from it in space, though 1e-4 in the chart.
TEST(CommonBorders, TakeCrossingsToCornersThatAreFartherInTheChartAlone) {
  const BezierSurface surface = fan();
  Chart chart = Chart().polygon({{0.5 - 1e-4, 1e-4}, {0.9, 2e-4}, {0.5, 0.9}});
  const TriangulatedRegion region = whole_region(surface, chart, within(1e-6));

  expect_no_short_arcs(region);
  EXPECT_GT(region.beyond_lines, 1e-9);
  EXPECT_LT(region.beyond_lines, 1e-7);
}

// The height of the lowest triangle, but for those with two corners at one point.
double lowest(const BezierSurface& surface, const TriangulatedRegion& region) {
  double least = 1;
  for (const RegionPiece& piece : region.pieces) {
    const auto* triangle = std::get_if<CurvedTriangle>(&piece.shape);
    if (!triangle) continue;
    std::vector<Vec3> at;
    for (const int vertex : triangle->vertices)
      at.push_back(point_at(surface, region.vertices[static_cast<std::size_t>(vertex)]));
    const double longest =
        std::max({distance(at[0], at[1]), distance(at[1], at[2]), distance(at[2], at[0])});
    if (at[0] != at[1] && at[1] != at[2] && at[2] != at[0])
      least = std::min(least, norm(cross(at[1] - at[0], at[2] - at[0])) / longest);
  }
  return least;
}

// Corners on the side u = 0 and another point of v = 0 are in one line in space, though not in the
// chart.
void expect_no_flat_triangles(const Vec2& far, double least_area) {
  const BezierSurface surface = sector(far);
  RegionOptions options;
  options.cells = 1;

  const TriangulatedRegion region = whole_region(surface, chart_of_sector(), options);

  for (const RegionPiece& piece : region.pieces) {
    std::vector<Vec3> at;
    for (const int vertex : std::get<CurvedTriangle>(piece.shape).vertices) {
      const Vec2 uv = region.vertices[static_cast<std::size_t>(vertex)];
      at.push_back(point_at(surface, uv));
    }
    const bool has_point = at[0] == at[1] || at[1] == at[2] || at[2] == at[0];
    EXPECT_TRUE(has_point || norm(cross(at[1] - at[0], at[2] - at[0])) > least_area);
  }
}

TEST(CommonBorders, LeavesNoFlatTrianglesBetweenARulingAndTheTip) {
  expect_no_flat_triangles({0.9, 0.4}, 1e-3);
}

TEST(CommonBorders, LeavesNoFlatTrianglesInNarrowSectors) {
  expect_no_flat_triangles({0.999, 0.03}, 1e-4);
}

// Narrow sectors, where corners of cells and ends of rulings are nearly in line with the tip, too.
TEST(CommonBorders, LeavesNoFlatTrianglesWhereTipsAreNarrow) {
  for (const int cells : {1, 2}) {
    const BezierSurface surface = sector({1, cells == 1 ? 0.05 : 0.3});
    RegionOptions options;
    options.cells = cells;

    const TriangulatedRegion region = whole_region(surface, chart_of_sector(), options);

    expect_on_surface(surface, region, 1e-14);
    EXPECT_NEAR(grid_area(region), 1, 1e-14);
    EXPECT_GT(lowest(surface, region), 1e-3) << cells;
  }
}

}  // namespace
}  // namespace blossom
