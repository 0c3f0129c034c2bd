// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces, charts and checks for tests of trimmed regions.

#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <variant>
#include <vector>

#include "core/blossom/triangle_blossom.h"
#include "core/blossom/triangle_composition.h"
#include "core/forms/evaluation.h"
#include "core/plane/loops.h"
#include "core/regions/triangulated_region.h"

namespace blossom::testing {

inline constexpr double kPi = std::numbers::pi;

// Heights over the square of the spans' knots, spans of one degree; C0 between the spans.
inline BezierSurface heights(const std::vector<double>& u, const std::vector<double>& v,
                             int degree) {
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

inline Chart whole(double u, double v) { return Chart().polygon({{0, 0}, {u, 0}, {u, v}, {0, v}}); }

// The area that the pieces cover, in grid coordinates.
inline double grid_area(const RegionPiece& piece) {
  if (const auto* cell = std::get_if<RegionCell>(&piece.shape))
    return length(cell->u) * length(cell->v);
  const BezierTriangle& map = std::get<CurvedTriangle>(piece.shape).map;
  const PlanarPath path{side_of(map, 0, 1), side_of(map, 1, 2), side_of(map, 2, 0)};
  return area_along(path, projected(map(0, 0)));
}

inline double grid_area(const TriangulatedRegion& region) {
  double sum = 0;
  for (const RegionPiece& piece : region.pieces) sum += grid_area(piece);
  return sum;
}

// Each side is used once in each direction, or it is an arc that is used once.
inline void expect_whole_sides(const TriangulatedRegion& region) {
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

inline void expect_on_surface(const BezierSurface& surface, const TriangulatedRegion& region,
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

}  // namespace blossom::testing
