// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/trimming/triangulated_region.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/base/errors.h"
#include "core/blossom/triangle_blossom.h"
#include "core/blossom/triangle_composition.h"
#include "core/forms/conversion.h"
#include "core/forms/evaluation.h"
#include "core/trimming/loops.h"
#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::seeded;
using testing::uniform;

constexpr double kPi = std::numbers::pi;

// Heights over the square of the spans' knots, spans of one degree; C0 between the spans.
BezierSurface heights(const std::vector<double>& u, const std::vector<double>& v, int degree) {
  BezierSurface surface;
  surface.u_knots = u;
  surface.v_knots = v;
  const int rows = static_cast<int>(u.size()) - 1, columns = static_cast<int>(v.size()) - 1;
  surface.patches = Grid<RationalBezierPatch>(rows, columns);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      RationalBezierPatch& patch = surface.patches(i, j);
      patch.points = Grid<Vec4>(degree + 1, degree + 1);
      for (int a = 0; a <= degree; ++a)
        for (int b = 0; b <= degree; ++b) {
          const auto at_knot = [&](const std::vector<double>& knots, int k, int c) {
            return at({knots[static_cast<std::size_t>(k)], knots[static_cast<std::size_t>(k) + 1]},
                      static_cast<double>(c) / degree);
          };
          const double x = at_knot(u, i, a), y = at_knot(v, j, b);
          patch.points(a, b) = {x, y, std::sin(2 * x) * std::cos(3 * y), 1};
        }
    }
  return surface;
}

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

class Chart {
 public:
  TrimmedChart made;

  Chart& polygon(const std::vector<Vec2>& points) {
    const int first = add_corners(points);
    for (std::size_t k = 0; k < points.size(); ++k)
      add(first + static_cast<int>(k), first + static_cast<int>((k + 1) % points.size()),
          planar_line(points[k], points[(k + 1) % points.size()], {0, 1}));
    return *this;
  }

  // A rational circle of four arcs with the angle as its parameter; a hole unless it is outer.
  Chart& circle(const Vec2& centre, double radius, bool outer = false) {
    PlanarCurve curve;
    for (int k = 0; k < 4; ++k) {
      const auto point = [&](double angle, double r, double w) {
        return Vec3{w * (centre[0] + r * std::cos(angle)), w * (centre[1] + r * std::sin(angle)),
                    w};
      };
      const double from = k * kPi / 2, w = std::sqrt(0.5);
      curve.spans.push_back({{{point(from, radius, 1), point(from + kPi / 4, radius / w, w),
                               point(from + kPi / 2, radius, 1)}},
                             {from, from + kPi / 2},
                             ParameterLaw::Angle});
    }
    const int corner = add_corners({centre + Vec2{radius, 0}});
    add(corner, corner, curve, !outer);
    return *this;
  }

  Chart& loop(const std::vector<PlanarBezier>& curves) {
    std::vector<Vec2> points;
    for (const PlanarBezier& curve : curves) points.push_back(projected(curve.points.front()));
    const int first = add_corners(points);
    for (std::size_t k = 0; k < curves.size(); ++k)
      add(first + static_cast<int>(k), first + static_cast<int>((k + 1) % curves.size()),
          {{{curves[k], {0, 1}, ParameterLaw::Linear}}});
    return *this;
  }

 private:
  int add_corners(const std::vector<Vec2>& points) {
    made.corners.insert(made.corners.end(), points.begin(), points.end());
    return static_cast<int>(made.corners.size() - points.size());
  }
  void add(int from, int to, PlanarCurve curve, bool reversed = false) {
    made.borders.push_back({std::move(curve), reversed, from, to, {}, false});
  }
};

Chart whole(double u, double v) { return Chart().polygon({{0, 0}, {u, 0}, {u, v}, {0, v}}); }

// The area that the pieces cover, in grid coordinates.
double grid_area(const RegionPiece& piece) {
  if (const auto* cell = std::get_if<RegionCell>(&piece.shape))
    return length(cell->u) * length(cell->v);
  const BezierTriangle& map = std::get<CurvedTriangle>(piece.shape).map;
  const PlanarPath path{side_of(map, 0, 1), side_of(map, 1, 2), side_of(map, 2, 0)};
  return area_along(path, projected(map(0, 0)));
}

double grid_area(const TriangulatedRegion& region) {
  double sum = 0;
  for (const RegionPiece& piece : region.pieces) sum += grid_area(piece);
  return sum;
}

// Each side is used once in each direction, or it is an arc that is used once.
void expect_whole_sides(const TriangulatedRegion& region) {
  std::map<std::pair<int, int>, int> uses;
  std::map<std::pair<int, int>, int> arc_of;
  for (std::size_t k = 0; k < region.arcs.size(); ++k)
    arc_of[{region.arcs[k].from, region.arcs[k].to}] = static_cast<int>(k);
  for (const RegionPiece& piece : region.pieces) {
    const auto* triangle = std::get_if<CurvedTriangle>(&piece.shape);
    const std::vector<int> v =
        triangle ? std::vector<int>(triangle->vertices.begin(), triangle->vertices.end())
                 : std::vector<int>(std::get<RegionCell>(piece.shape).vertices.begin(),
                                    std::get<RegionCell>(piece.shape).vertices.end());
    for (std::size_t k = 0; k < v.size(); ++k) {
      ++uses[{v[k], v[(k + 1) % v.size()]}];
      const std::pair ends{v[k], v[(k + 1) % v.size()]};
      const bool on_arc = triangle && triangle->arcs[k] >= 0;
      EXPECT_EQ(on_arc ? arc_of.at(ends) : -1, on_arc ? triangle->arcs[k] : -1);
    }
  }
  for (const auto& [ends, count] : uses) {
    EXPECT_EQ(count, 1);
    const bool inner = uses.count({ends.second, ends.first}) > 0;
    EXPECT_NE(inner, arc_of.count(ends) > 0) << ends.first << " " << ends.second;
  }
  for (const auto& [ends, arc] : arc_of) EXPECT_EQ(uses.count(ends), 1u);
}

void expect_on_surface(const BezierSurface& surface, const TriangulatedRegion& region,
                       double tolerance) {
  for (const RegionPiece& piece : region.pieces) {
    const RegionForm form = bezier_form(surface, piece);
    const RationalBezierPatch& patch = surface.patches(piece.patch_u, piece.patch_v);
    if (const auto* made = std::get_if<RationalBezierTriangle>(&form)) {
      const BezierTriangle& map = std::get<CurvedTriangle>(piece.shape).map;
      const Vec2 at{0.3, 0.5};
      const Vec3 uv = blossom_at(map, std::vector<Vec2>(static_cast<std::size_t>(map.degree), at));
      const Vec4 p =
          blossom_at(*made, std::vector<Vec2>(static_cast<std::size_t>(made->degree), at));
      EXPECT_LE(distance(Vec3{p[0], p[1], p[2]} * (1 / p[3]),
                         point_at(patch, uv[0] / uv[2], uv[1] / uv[2])),
                tolerance);
    } else {
      const RegionCell& cell = std::get<RegionCell>(piece.shape);
      EXPECT_LE(distance(point_at(std::get<RationalBezierPatch>(form), 0.3, 0.6),
                         point_at(patch, blossom::at(cell.u, 0.3), blossom::at(cell.v, 0.6))),
                tolerance);
    }
  }
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
  expect_on_surface(surface, region, 1e-13);
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

TEST(TriangulatedRegion, OfACylinderFollowsItsAngles) {
  const BezierSurface surface = quarter_cylinder();
  Chart chart = whole(kPi / 2, 1).circle({0.8, 0.5}, 0.3);

  const TriangulatedRegion region = triangulated_region(surface, chart.made);

  ASSERT_TRUE(region.obstacle.empty()) << region.obstacle;
  EXPECT_GT(cell_count(region), 0u);
  expect_whole_sides(region);
  expect_on_surface(surface, region, 1e-14);
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

// With common borders the arcs run as evenly as the angle of the circle does.
TEST(TriangulatedRegion, KeepsParametersForCommonBorders) {
  const BezierSurface surface = heights({0, 1}, {0, 1}, 3);
  Chart chart = whole(1, 1).circle({0.5, 0.5}, 0.3);
  RegionOptions options;
  options.common_borders = true;
  options.tolerance = 1e-8;

  const TriangulatedRegion region = triangulated_region(surface, chart.made, options);

  ASSERT_TRUE(region.obstacle.empty()) << region.obstacle;
  expect_whole_sides(region);
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
TEST(TriangulatedRegion, TakesCrossingsOfCommonBordersToStopsBesideThem) {
  const BezierSurface surface = heights({0, 0.5, 1}, {0, 0.5, 1}, 3);
  Chart chart = Chart().polygon(
      {{0.1, 0.1}, {0.5 - 3e-8, 0.2}, {0.9, 0.1}, {0.7, 0.9}, {0.5, 0.8}, {0.3, 0.9}});
  chart.made.borders[2].stops = {0.5 + 3e-8};
  RegionOptions options;
  options.common_borders = true;
  options.tolerance = 1e-6;

  const TriangulatedRegion region = triangulated_region(surface, chart.made, options);

  ASSERT_TRUE(region.obstacle.empty()) << region.obstacle;
  expect_whole_sides(region);
  expect_on_surface(surface, region, 1e-14);
  for (const RegionArc& arc : region.arcs) {
    const Vec2 way = region.vertices[static_cast<std::size_t>(arc.to)] -
                     region.vertices[static_cast<std::size_t>(arc.from)];
    EXPECT_GT(norm(way), 1e-3);
  }
  EXPECT_TRUE(std::ranges::count(region.stops[2], 0.5 + 3e-8));
  EXPECT_GT(region.beyond_lines, 2e-8);
  EXPECT_LT(region.beyond_lines, options.tolerance);

  options.common_borders = false;
  EXPECT_EQ(triangulated_region(surface, chart.made, options).beyond_lines, 0);
}

// A sector with its tip along v = 0: corners on the side u = 0 and another point of v = 0 are in
// one line in space, though not in the chart.
TEST(TriangulatedRegion, LeavesNoFlatTrianglesBetweenARulingAndTheTip) {
  BezierSurface surface = heights({0, 1}, {0, 1}, 1);
  RationalBezierPatch& patch = surface.patches(0, 0);
  patch.points(0, 0) = patch.points(1, 0) = {0, 0, 0, 1};
  patch.points(0, 1) = {1, 0, 0, 1};
  patch.points(1, 1) = {0.9, 0.4, 0, 1};
  Chart chart = whole(1, 1);
  chart.made.borders[0].is_point = true;
  for (int k = 1; k < 16; ++k) chart.made.borders[3].stops.push_back(k / 16.0);
  RegionOptions options;
  options.common_borders = true;
  options.cells = 1;

  const TriangulatedRegion region = triangulated_region(surface, chart.made, options);

  ASSERT_TRUE(region.obstacle.empty()) << region.obstacle;
  expect_whole_sides(region);
  for (const RegionPiece& piece : region.pieces) {
    std::vector<Vec3> at;
    for (const int vertex : std::get<CurvedTriangle>(piece.shape).vertices) {
      const Vec2 uv = region.vertices[static_cast<std::size_t>(vertex)];
      at.push_back(point_at(patch, uv[0], uv[1]));
    }
    const bool has_point = at[0] == at[1] || at[1] == at[2] || at[2] == at[0];
    EXPECT_TRUE(has_point || norm(cross(at[1] - at[0], at[2] - at[0])) > 1e-3);
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
