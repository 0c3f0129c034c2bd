// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/watertight/watertight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "core/base/errors.h"
#include "core/blossom/triangle_composition.h"
#include "core/forms/algebra/de_casteljau.h"
#include "core/forms/algebra/degree.h"
#include "core/forms/algebra/interpolation.h"
#include "core/forms/evaluation.h"

namespace blossom {
namespace {

// A patch z = f(x, y) over [0, 1]^2 and a wall below its side y = 0; the wall is `gap` off. A hole
// in the patch makes it trimmed. The common edge is a circle's arc in the wall's chart, of another
// parameter than the patch's.
double height(double x) { return 1 + 0.3 * std::sin(2 * x); }

BezierSurface roof() {
  BezierSurface surface{{0, 1}, {0, 0.5, 1}};
  surface.patches = Grid<RationalBezierPatch>(1, 2);
  for (int j = 0; j < 2; ++j) {
    RationalBezierPatch& patch = surface.patches(0, j);
    patch.points = Grid<Vec4>(4, 4);
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < 4; ++b) {
        const double x = a / 3.0, y = 0.5 * j + b / 6.0;
        patch.points(a, b) = {x, y, height(x) + y * y, 1};
      }
  }
  return surface;
}

Vec3 edge_point(double t) {
  Vec3 p = point_at(roof(), {t, 0});
  return p;
}

// The wall x-z at y = gap, in two patches; its upper border in the chart is z as a cubic of x.
CommonModel roof_and_wall(double gap) {
  CommonModel model;
  const BezierSurface top = roof();
  BezierSurface wall{{0, 0.4, 1}, {0, 3}};
  wall.patches = Grid<RationalBezierPatch>(2, 1);
  for (int i = 0; i < 2; ++i) {
    RationalBezierPatch& patch = wall.patches(i, 0);
    patch.points = Grid<Vec4>(2, 2);
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b)
        patch.points(a, b) = {wall.u_knots[static_cast<std::size_t>(i + a)], gap, 3.0 * b, 1};
  }
  PlanarBezier curve;  // (x, z) of the edge
  for (int a = 0; a < 4; ++a) {
    const Vec4 p = top.patches(0, 0).points(a, 0);
    curve.points.push_back({p[0], p[2], 1});
  }
  const Vec3 left = edge_point(0), right = edge_point(1);
  model.vertices = {left,      right,    point_at(top, {1, 1}), point_at(top, {0, 1}),
                    {0, 0, 0}, {1, 0, 0}};
  const auto straight = [&](int from, int to) {
    const Vec3 a = model.vertices[static_cast<std::size_t>(from)];
    const Vec3 b = model.vertices[static_cast<std::size_t>(to)];
    return CommonEdge{[a, b](double t) { return (1 - t) * a + t * b; }, {0, 1}, from, to};
  };
  const auto on_top = [top](const Vec2& from, const Vec2& to) {
    return [=](double t) { return point_at(top, (1 - t) * from + t * to); };
  };
  model.edges = {{edge_point, {0, 1}, 0, 1},
                 {on_top({1, 0}, {1, 1}), {0, 1}, 1, 2},
                 {on_top({1, 1}, {0, 1}), {0, 1}, 2, 3},
                 {on_top({0, 1}, {0, 0}), {0, 1}, 3, 0},
                 straight(0, 4),
                 straight(4, 5),
                 straight(5, 1)};
  const auto line = [](const Vec2& a, const Vec2& b) { return planar_line(a, b, {0, 1}); };
  CommonFace roof_face{top, {}, {0, 1, 2, 3}};
  roof_face.chart.corners = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (int k = 0; k < 4; ++k)
    roof_face.chart.borders.push_back(
        {line(roof_face.chart.corners[static_cast<std::size_t>(k)],
              roof_face.chart.corners[static_cast<std::size_t>((k + 1) % 4)]),
         false,
         k,
         (k + 1) % 4,
         {}});
  CommonFace wall_face{wall, {}, {0, 4, 5, 6}};
  wall_face.chart.corners = {{0, left[2]}, {1, right[2]}, {0, 0}, {1, 0}};
  wall_face.chart.borders = {{{{{curve, {0, 1}}}}, true, 1, 0, {}, false},
                             {line({0, left[2]}, {0, 0}), false, 0, 2, {}, false},
                             {line({0, 0}, {1, 0}), false, 2, 3, {}, false},
                             {line({1, 0}, {1, right[2]}), false, 3, 1, {}, false}};
  model.faces = {roof_face, wall_face};
  return model;
}

// A square in the plane through three points, in two patches that meet at u = split and reach
// beyond it.
CommonFace square(const Vec3& origin, const Vec3& along_u, const Vec3& along_v, double split,
                  double reach, const std::vector<int>& edges, const std::vector<bool>& reversed) {
  BezierSurface surface{{-reach, split, 1 + reach}, {-reach, 1 + reach}};
  surface.patches = Grid<RationalBezierPatch>(2, 1);
  for (int i = 0; i < 2; ++i) {
    RationalBezierPatch& patch = surface.patches(i, 0);
    patch.points = Grid<Vec4>(2, 2);
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b) {
        const double u = surface.u_knots[static_cast<std::size_t>(i + a)];
        const Vec3 p =
            origin + u * along_u + surface.v_knots[static_cast<std::size_t>(b)] * along_v;
        patch.points(a, b) = {p[0], p[1], p[2], 1};
      }
  }
  CommonFace face{surface, {}, edges};
  face.chart.corners = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t next = (k + 1) % 4, from = reversed[k] ? next : k;
    const std::size_t to = reversed[k] ? k : next;
    face.chart.borders.push_back(
        {planar_line(face.chart.corners[from], face.chart.corners[to], {0, 1}),
         reversed[k],
         static_cast<int>(k),
         static_cast<int>(next),
         {}});
  }
  return face;
}

// Two squares with a common edge, on which their lines between patches end `apart` from each other.
CommonModel two_squares(double apart, double reach = 0) {
  CommonModel model;
  model.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}};
  for (const auto& [from, to] :
       std::vector<std::pair<int, int>>{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {1, 5}, {5, 4}, {4, 0}}) {
    const Vec3 a = model.vertices[static_cast<std::size_t>(from)];
    const Vec3 b = model.vertices[static_cast<std::size_t>(to)];
    model.edges.push_back({[a, b](double t) { return (1 - t) * a + t * b; }, {0, 1}, from, to});
  }
  model.faces = {square({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0.4 + apart, reach, {0, 1, 2, 3},
                        {false, false, false, false}),
                 square({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 0.4, reach, {0, 4, 5, 6},
                        {false, false, false, false})};
  return model;
}

BezierCurve side_curve(const WatertightPiece& piece, int k) {
  return side_of(std::get<BezierTriangle>(piece.form), k, (k + 1) % 3);
}

// The pieces' curves along each side of an edge, turned to the side's direction.
std::map<int, std::vector<BezierCurve>> curves_on_edges(const WatertightPieces& made) {
  std::map<int, std::vector<BezierCurve>> curves;
  for (const WatertightPiece& piece : made.pieces)
    for (std::size_t k = 0; k < piece.sides.size(); ++k) {
      const WatertightSide& side = made.sides[static_cast<std::size_t>(piece.sides[k])];
      if (side.edge < 0) continue;
      BezierCurve curve = side_curve(piece, static_cast<int>(k));
      if (piece.vertices[k] != side.from) std::ranges::reverse(curve.points);
      curves[piece.sides[k]].push_back(std::move(curve));
    }
  return curves;
}

TEST(WatertightPieces, ShareTheControlPointsOfTheirCommonEdgeBitForBit) {
  const WatertightPieces made = watertight_pieces(roof_and_wall(1e-5));

  ASSERT_TRUE(made.obstacle.empty()) << made.obstacle;
  int common = 0;
  for (const auto& [number, curves] : curves_on_edges(made)) {
    const WatertightSide& side = made.sides[static_cast<std::size_t>(number)];
    ASSERT_EQ(curves.size(), side.edge == 0 ? 2u : 1u);
    for (const BezierCurve& curve : curves) EXPECT_EQ(curve.points, side.curve.points);
    common += side.edge == 0 ? 1 : 0;
  }
  EXPECT_GE(common, 2);  // the wall's two patches
}

TEST(WatertightPieces, MoveByNoMoreThanTheyState) {
  for (const double gap : {0.0, 1e-8, 1e-5, 1e-3}) {
    const CommonModel model = roof_and_wall(gap);

    const WatertightPieces made = watertight_pieces(model);

    ASSERT_TRUE(made.obstacle.empty());
    EXPECT_LE(made.deviation, std::max(1e-6, 1.01 * gap));
    double seen = 0;
    for (const WatertightPiece& piece : made.pieces) {
      const auto* triangle = std::get_if<BezierTriangle>(&piece.form);
      for (double x = 0; triangle && x <= 1; x += 0.125)
        for (double y = 0; x + y <= 1; y += 0.125) {
          const Vec3 p = point_at(*triangle, x, y);
          const double off = piece.face == 0
                                 ? distance(p, point_at(model.faces[0].surface, {p[0], p[1]}))
                                 : std::abs(p[1] - gap);
          EXPECT_LE(off, 2 * piece.moved + 1e-14);  // here the nearest, there at equal parameters
          seen = std::max(seen, off);
        }
    }
    EXPECT_GE(seen, 0.9 * gap);
  }
}

// A curve through the vertex and other points of the edge would swing several times as far.
TEST(WatertightPieces, MoveHardlyFartherThanVerticesAreFromTheirEdges) {
  CommonModel model = roof_and_wall(0);
  model.vertices[0] += Vec3{0, 0, 1e-3};

  const WatertightPieces made = watertight_pieces(model);

  ASSERT_EQ(made.obstacle, "");
  EXPECT_GE(made.deviation, 1e-3);
  EXPECT_LE(made.deviation, 1.1e-3);
}

// The wall's border as another edge gives it that runs the other way and unevenly.
TEST(WatertightPieces, TakeBordersWithParametersOfTheirOwn) {
  CommonModel model = roof_and_wall(1e-5);
  const auto to_edge = [](double t) { return 1 - 0.5 * (t - 3) * (t - 2); };
  const auto from_edge = [](double s) { return 2.5 + 0.5 * std::sqrt(9 - 8 * s); };
  CommonFace& wall = model.faces[1];
  PlanarCurve& border = wall.chart.borders[0].curve;
  std::vector<Vec2> points;
  for (const double x : extreme_points(6)) points.push_back(point_at(border, to_edge(3 + x)));
  PlanarBezier curve;
  for (const Vec2& p : bezier_through(points).points) curve.points.push_back({p[0], p[1], 1});
  border = {{{curve, {3, 4}}}};
  wall.chart.borders[0].reversed = false;
  wall.parameters.resize(4);
  wall.parameters[0] = {to_edge, from_edge};

  const WatertightPieces made = watertight_pieces(model);

  ASSERT_EQ(made.obstacle, "");
  EXPECT_LE(made.deviation, 4e-5);  // four times the gap is not worth more pieces
  int common = 0;
  for (const auto& [number, curves] : curves_on_edges(made)) {
    const WatertightSide& side = made.sides[static_cast<std::size_t>(number)];
    ASSERT_EQ(curves.size(), side.edge == 0 ? 2u : 1u);
    for (const BezierCurve& c : curves) EXPECT_EQ(c.points, side.curve.points);
    common += side.edge == 0 ? 1 : 0;
  }
  EXPECT_GE(common, 2);
}

// The lower border of the wall is a piece of an ellipse, which takes many arcs.
TEST(WatertightPieces, AreNoFinerThanTheirEdgesAreNear) {
  CommonModel model = roof_and_wall(0);
  const PlanarCurve arc{{{{{{0, 0, 1}, {0.4, 0.6, 0.8}, {1, 0, 1}}}, {0, 1}}}};
  model.faces[1].chart.borders[2].curve = arc;
  model.edges[5].point = [arc](double t) {
    const Vec2 p = point_at(arc, t);
    return Vec3{p[0], 0, p[1]};
  };
  WatertightOptions options;
  options.tolerance = 1e-9;
  const std::size_t fine = watertight_pieces(model, options).pieces.size();
  model.edges[5].apart = 0.03;

  const WatertightPieces made = watertight_pieces(model, options);

  ASSERT_EQ(made.obstacle, "");
  EXPECT_LT(made.pieces.size(), 0.75 * static_cast<double>(fine));
  EXPECT_LE(made.deviation, 0.03);
}

// Each side is used twice inside and on the common edge, once on free edges.
TEST(WatertightPieces, UseEverySideAsOftenAsThereAreFaces) {
  const WatertightPieces made = watertight_pieces(roof_and_wall(0));

  std::map<int, int> uses;
  for (const WatertightPiece& piece : made.pieces)
    for (const int side : piece.sides) ++uses[side];
  for (const auto& [side, count] : uses) {
    const int edge = made.sides[static_cast<std::size_t>(side)].edge;
    EXPECT_EQ(count, edge <= 0 ? 2 : 1);
  }
}

class NearlyMeeting : public ::testing::TestWithParam<double> {};

TEST_P(NearlyMeeting, LinesBetweenPatchesDoNotKeepFacesFromAgreeing) {
  for (const double reach : {0.0, 1.0, 30.0}) {
    const WatertightPieces made = watertight_pieces(two_squares(GetParam(), reach));
    EXPECT_EQ(made.obstacle, "");
    EXPECT_LE(made.deviation, 1e-6);
    EXPECT_GE(made.pieces.size(), 4u);
    // Where patches reach farther, points on the common edge that are two may count as on one line.
    for (const auto& [number, curves] : curves_on_edges(made))
      EXPECT_EQ(curves.size(), made.sides[static_cast<std::size_t>(number)].edge == 0 ? 2u : 1u);
  }
}

INSTANTIATE_TEST_SUITE_P(Distances, NearlyMeeting,
                         ::testing::Values(0, 3e-10, 0.9e-9, 1.5e-9, 1.9e-9, 2.5e-9, 1e-8, 1e-6));

// Over the arc the roof's triangles have degree 3 x (3 + 3), but nothing like it is in them.
TEST(WatertightPieces, HaveHardlyMoreThanTheDegreesOfTheirSurfaces) {
  WatertightOptions fine;
  fine.tolerance = 1e-9;
  const WatertightPieces made = watertight_pieces(roof_and_wall(0)),
                         finer = watertight_pieces(roof_and_wall(0), fine);
  const auto highest = [](const WatertightPieces& pieces) {
    int most = 0;
    for (const WatertightPiece& piece : pieces.pieces)
      if (const auto* triangle = std::get_if<BezierTriangle>(&piece.form))
        most = std::max(most, triangle->degree);
    return most;
  };
  EXPECT_LE(highest(made), 6);
  EXPECT_LE(highest(finer), 8);
  EXPECT_LE(made.deviation, 1e-6);
  EXPECT_LE(finer.deviation, 1e-9);
}

// A part of a roof of degrees 7 x 6 within a loop of four cubics, nearly a circle.
CommonModel disc_of_high_degree() {
  CommonModel model;
  CommonFace face{BezierSurface{{0, 1}, {0, 1}}, {}, {0, 1, 2, 3}};
  face.surface.patches = Grid<RationalBezierPatch>(1, 1);
  face.surface.patches(0, 0) = elevated(roof().patches(0, 0), 7, 6);
  const BezierSurface surface = face.surface;
  for (int k = 0; k < 4; ++k) {
    const auto turned = [k](double x, double y) {
      const double c = k % 2 == 0 ? 1 - k : 0, s = k % 2 == 0 ? 0 : 2 - k;
      return Vec2{0.5 + 0.4 * (c * x - s * y), 0.5 + 0.4 * (s * x + c * y)};
    };
    PlanarBezier arc;
    for (const Vec2& p : {turned(1, 0), turned(1, 0.55), turned(0.55, 1), turned(0, 1)})
      arc.points.push_back({p[0], p[1], 1});
    const PlanarCurve curve{{{arc, {0, 1}}}};
    face.chart.corners.push_back(turned(1, 0));
    face.chart.borders.push_back({curve, false, k, (k + 1) % 4, {}});
    model.edges.push_back(
        {[surface, curve](double t) { return point_at(surface, point_at(curve, t)); },
         {0, 1},
         k,
         (k + 1) % 4});
    model.vertices.push_back(model.edges.back().point(0));
  }
  model.faces = {face};
  return model;
}

// Triangles of degree 25 would leave straight arcs alone, more than 500 for each border.
TEST(WatertightPieces, TakeCubicArcsOnSurfacesOfHighDegrees) {
  const WatertightPieces made = watertight_pieces(disc_of_high_degree());

  EXPECT_EQ(made.obstacle, "");
  EXPECT_LE(made.deviation, 1e-6);
  EXPECT_LE(made.pieces.size(), 200u);
  for (const WatertightPiece& piece : made.pieces) {
    const auto* triangle = std::get_if<BezierTriangle>(&piece.form);
    EXPECT_LE(triangle ? triangle->degree : 0, kMaxDegree);
  }
}

TEST(WatertightPieces, EndWhereTheOneThatIsAskedWantsItToEnd) {
  struct Ended {};
  int asked = 0;
  WatertightOptions options;
  options.ask = [&asked] { return ++asked > 0; };
  ASSERT_EQ(watertight_pieces(two_squares(0), options).obstacle, "");
  ASSERT_EQ(asked, 7);  // of two faces: their surfaces, regions and pieces; then, what folds over

  const std::vector<std::vector<int>> open{{0, 1}, {0, 1}, {0, 1}, {1}, {0, 1}, {1}, {0, 1}};
  for (int left = 0; left < asked; ++left) {
    int goes_on = left;
    options.ask = [&goes_on] { return goes_on-- > 0; };
    const WatertightPieces made = watertight_pieces(two_squares(0), options);
    EXPECT_NE(made.obstacle, "");
    EXPECT_TRUE(made.pieces.empty());
    EXPECT_EQ(made.open, open[static_cast<std::size_t>(left)]) << left;
  }

  options.ask = []() -> bool { throw Ended(); };
  EXPECT_THROW(watertight_pieces(two_squares(0), options), Ended);
}

TEST(WatertightPieces, RefuseWhatNamesNothing) {
  CommonModel model = roof_and_wall(0);
  model.faces[0].edges[1] = 9;
  EXPECT_THROW(watertight_pieces(model), InvalidInput);
  model = roof_and_wall(0);
  model.edges[3].to = 6;
  EXPECT_THROW(watertight_pieces(model), InvalidInput);
}

}  // namespace
}  // namespace blossom
