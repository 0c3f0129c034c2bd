// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tessellation/shape_facets.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "core/base/errors.h"
#include "core/base/parallel.h"
#include "tests/support/random.h"
#include "tests/support/region_lines.h"

namespace blossom {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

using testing::line;

CurveSpans straight(const Vec3& a, const Vec3& b) { return curve_spans(BezierCurve{{a, b}}); }

// The unit square in z = 0, as one face.
ShapeModel square() {
  ShapeModel model;
  model.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  ModelFace face;
  face.surface = ElementaryChart{};
  const Vec2 corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (int k = 0; k < 4; ++k) {
    const int next = (k + 1) % 4;
    model.edges.push_back({straight(model.vertices[static_cast<std::size_t>(k)],
                                    model.vertices[static_cast<std::size_t>(next)]),
                           k, next});
    face.chart.borders.push_back(line(corners[k], corners[next], k, next));
    face.edges.push_back(k);
  }
  face.chart.corners.assign(corners, corners + 4);
  model.faces.push_back(face);
  return model;
}

double area(const ShapeFacets& facets) {
  double sum = 0;
  for (const MeshedFace& face : facets.faces)
    for (const auto& [i, j, k] : face.triangles) {
      const auto point = [&](int corner) {
        return facets
            .points[static_cast<std::size_t>(face.vertices[static_cast<std::size_t>(corner)])];
      };
      sum += 0.5 * norm(cross(point(j) - point(i), point(k) - point(i)));
    }
  return sum;
}

// How many facets are at each side.
std::map<std::pair<int, int>, int> side_uses(const ShapeFacets& facets) {
  std::map<std::pair<int, int>, int> uses;
  for (const MeshedFace& face : facets.faces)
    for (const auto& triangle : face.triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const int from = face.vertices[static_cast<std::size_t>(triangle[k])],
                  to = face.vertices[static_cast<std::size_t>(triangle[(k + 1) % 3])];
        ++uses[std::minmax(from, to)];
      }
  return uses;
}

TEST(ShapeFacets, OfASquareAreTwoTriangles) {
  const ShapeFacets facets = shape_facets(square(), {.deviation = 0.1});
  ASSERT_EQ(facets.faces.size(), 1u);
  EXPECT_EQ(facets.faces[0].triangles.size(), 2u);
  EXPECT_EQ(facets.points.size(), 4u);
  EXPECT_DOUBLE_EQ(area(facets), 1);
  EXPECT_NEAR(facets.distance, 0, 1e-15);
  for (const Vec3& n : facets.faces[0].normals) EXPECT_EQ(n, (Vec3{0, 0, 1}));
}

// What repairs put into gaps of wires: its ends are one corner, as the vertex is wider than it.
TEST(ShapeFacets, DoNotFollowAPointOfASurfaceOutAndBack) {
  ShapeModel model = square();
  model.edges.push_back({{}, 1, 1, true});
  ModelFace& face = model.faces[0];
  face.chart.corners.push_back(face.chart.corners[1]);
  face.chart.borders[1].from = 4;
  face.chart.borders.push_back(line({1, 0}, {1, 1e-6}, 1, 4));
  face.edges.push_back(4);
  const ShapeFacets facets = shape_facets(model, {.deviation = 0.1});
  EXPECT_EQ(facets.faces[0].obstacle, "");
  EXPECT_EQ(facets.faces[0].triangles.size(), 2u);
}

TEST(ShapeFacets, HaveSidesOfAboutTheWantedLength) {
  const ShapeFacets facets = shape_facets(square(), {.deviation = 0.1, .edge_length = 0.1});
  EXPECT_GE(facets.faces[0].triangles.size(), 200u);
  EXPECT_LE(facets.faces[0].triangles.size(), 320u);
  EXPECT_NEAR(area(facets), 1, 1e-12);
}

// A roof, bent in one direction alone, four times as long as wide.
ShapeModel roof() {
  ShapeModel model = square();
  model.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 4, 0}, {0, 4, 0}};
  const auto arch = [](double from, double to, double y) {
    return curve_spans(BezierCurve{{{from, y, 0}, {0.5, y, 1}, {to, y, 0}}});
  };
  model.edges[0].curve = arch(0, 1, 0);
  model.edges[1].curve = straight({1, 0, 0}, {1, 4, 0});
  model.edges[2].curve = arch(1, 0, 4);
  model.edges[3].curve = straight({0, 4, 0}, {0, 0, 0});
  RationalBezierPatch patch{Grid<Vec4>(3, 2)};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 2; ++j) patch.points(i, j) = {0.5 * i, 4.0 * j, i == 1 ? 1.0 : 0.0, 1};
  BezierSurface surface;
  surface.patches = Grid<RationalBezierPatch>(1, 1);
  surface.patches(0, 0) = patch;
  surface.u_knots = surface.v_knots = {0, 1};
  model.faces[0].surface = surface;
  return model;
}

// Of all facets the most: the longest side over the height above it.
double longest_aspect(const ShapeFacets& facets) {
  double most = 0;
  for (const MeshedFace& face : facets.faces)
    for (const std::array<int, 3>& triangle : face.triangles) {
      std::array<Vec3, 3> p;
      for (std::size_t k = 0; k < 3; ++k)
        p[k] = facets.points[static_cast<std::size_t>(
            face.vertices[static_cast<std::size_t>(triangle[k])])];
      const double side =
          std::max({distance(p[0], p[1]), distance(p[1], p[2]), distance(p[2], p[0])});
      most = std::max(most, side * side / norm(cross(p[1] - p[0], p[2] - p[0])));
    }
  return most;
}

TEST(ShapeFacets, AreAboutAsLongAsTheirAspectAllows) {
  const FacetOptions plain{.deviation = 0.005, .angle = 0};
  FacetOptions even = plain;
  even.aspect = 2;
  const ShapeFacets longer = shape_facets(roof(), plain), shorter = shape_facets(roof(), even);
  EXPECT_GT(longest_aspect(longer), 20);
  EXPECT_LT(longest_aspect(shorter), 8);
  EXPECT_LE(shorter.distance, 0.005);
  even.aspect = 0.5;
  EXPECT_THROW(shape_facets(roof(), even), InvalidInput);
}

// A whole sphere: a seam, and a pole at either end of it.
ShapeModel sphere(double radius) {
  ShapeModel model;
  model.vertices = {{0, 0, -radius}, {0, 0, radius}};
  CurveSpans seam;
  const double w = std::sqrt(0.5);
  seam.rational = true;
  for (const double z : {-1.0, 1.0}) {
    CurveSpan span;
    span.curve.points = {{0, 0, -radius, 1}, {w * radius, 0, -w * radius, w}, {radius, 0, 0, 1}};
    if (z > 0)
      span.curve.points = {{radius, 0, 0, 1}, {w * radius, 0, w * radius, w}, {0, 0, radius, 1}};
    span.place = z < 0 ? Interval{-kTurn / 4, 0} : Interval{0, kTurn / 4};
    span.law = ParameterLaw::Angle;
    seam.spans.push_back(span);
  }
  model.edges = {{{}, 0, 0, true}, {seam, 0, 1}, {{}, 1, 1, true}};
  ModelFace face;
  face.surface = ElementaryChart{.kind = ElementaryKind::Sphere, .radius = radius};
  const double low = -kTurn / 4, high = kTurn / 4;
  face.chart.corners = {{0, low}, {kTurn, low}, {kTurn, high}, {0, high}};
  RegionBorder right = line({kTurn, low}, {kTurn, high}, 1, 2), left;
  right.curve = planar_line({kTurn, low}, {kTurn, high}, {low, high});
  left = line({0, low}, {0, high}, 3, 0, true);
  left.curve = planar_line({0, low}, {0, high}, {low, high});
  face.chart.borders = {line({0, low}, {kTurn, low}, 0, 1), right,
                        line({kTurn, high}, {0, high}, 2, 3), left};
  face.chart.borders[0].is_point = face.chart.borders[2].is_point = true;
  face.edges = {0, 1, 2, 1};
  model.faces.push_back(face);
  return model;
}

// How often sides are walked on more than back; empty if the mesh is closed.
std::map<std::pair<int, int>, int> open_sides(const ShapeFacets& facets) {
  std::map<std::pair<int, int>, int> sides;
  for (const MeshedFace& face : facets.faces)
    for (const auto& triangle : face.triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const int a = face.vertices[static_cast<std::size_t>(triangle[k])];
        const int b = face.vertices[static_cast<std::size_t>(triangle[(k + 1) % 3])];
        ++sides[{a, b}];
        --sides[{b, a}];
      }
  std::erase_if(sides, [](const auto& side) { return side.second == 0; });
  return sides;
}

TEST(ShapeFacets, OfASphereAreClosedAndWithinTheDeviation) {
  for (const double deviation : {0.5, 0.05, 0.005}) {
    const ShapeFacets facets = shape_facets(sphere(2), {.deviation = deviation, .angle = 0});
    EXPECT_TRUE(open_sides(facets).empty());
    EXPECT_LE(facets.distance, deviation);
    for (const Vec3& p : facets.points) EXPECT_NEAR(norm(p), 2, 1e-12);
    double worst = 0;
    for (const auto& [i, j, k] : facets.faces[0].triangles) {
      Vec3 middle;
      for (const int corner : {i, j, k})
        middle += facets.points[static_cast<std::size_t>(
                      facets.faces[0].vertices[static_cast<std::size_t>(corner)])] *
                  (1.0 / 3);
      worst = std::max(worst, 2 - norm(middle));
    }
    EXPECT_LE(worst, facets.distance);
    EXPECT_GE(worst, facets.distance / 3);
    EXPECT_EQ(facets.faces[0].folded, 0);
  }
}

// A strip that curls up at one border by far less than the deviation: there its normal has turned
// by more than a right angle, which is no fold.
TEST(ShapeFacets, OfALipAreNotFolded) {
  const std::array<std::array<Vec3, 3>, 2> profile{
      std::array{Vec3{0, 0, 0}, Vec3{-0.01, 0.01, 0}, Vec3{0.01, 0.01, 0}},
      std::array{Vec3{0.01, 0.01, 0}, Vec3{0.5, 0.01, 0}, Vec3{1, 0.01, 0}}};
  const Vec3 up{0, 0, 1};
  BezierSurface surface;
  surface.u_knots = {0, 0.01, 1};  // about its length
  surface.v_knots = {0, 1};
  surface.patches = Grid<RationalBezierPatch>(2, 1);
  std::array<CurveSpans, 2> rims;
  for (int k = 0; k < 2; ++k) {
    Grid<Vec4>& net = surface.patches(k, 0).points;
    net = Grid<Vec4>(3, 2);
    for (int j = 0; j < 2; ++j) {
      CurveSpan span;
      for (int i = 0; i < 3; ++i) {
        const Vec3 p = profile[static_cast<std::size_t>(k)][static_cast<std::size_t>(i)] + j * up;
        net(i, j) = {p[0], p[1], p[2], 1};
        span.curve.points.push_back(net(i, j));
      }
      span.place = {surface.u_knots[static_cast<std::size_t>(k)],
                    surface.u_knots[static_cast<std::size_t>(k) + 1]};
      rims[static_cast<std::size_t>(j)].spans.push_back(span);
    }
  }
  ShapeModel model;
  model.vertices = {{0, 0, 0}, {1, 0.01, 0}, {1, 0.01, 1}, {0, 0, 1}};
  model.edges = {{rims[0], 0, 1},
                 {straight(model.vertices[1], model.vertices[2]), 1, 2},
                 {rims[1], 3, 2},
                 {straight(model.vertices[0], model.vertices[3]), 0, 3}};
  ModelFace face;
  face.surface = surface;
  face.chart.corners = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  face.chart.borders = {line({0, 0}, {1, 0}, 0, 1), line({1, 0}, {1, 1}, 1, 2),
                        line({0, 1}, {1, 1}, 2, 3, true), line({0, 0}, {0, 1}, 3, 0, true)};
  face.edges = {0, 1, 2, 3};
  model.faces.push_back(face);

  const ShapeFacets facets = shape_facets(model, {.deviation = 0.1, .angle = 0});

  EXPECT_TRUE(facets.faces[0].obstacle.empty()) << facets.faces[0].obstacle;
  EXPECT_EQ(facets.faces[0].folded, 0);
  EXPECT_LE(facets.faces[0].triangles.size(), 12u);
}

// The whole of a patch over the unit square.
ShapeModel whole_patch(const RationalBezierPatch& patch) {
  const int rows = patch.points.rows() - 1, columns = patch.points.columns() - 1;
  const auto row = [&](bool along_u, int at) {
    BezierCurve curve;
    for (int k = 0; k <= (along_u ? rows : columns); ++k)
      curve.points.push_back(projected(along_u ? patch.points(k, at) : patch.points(at, k)));
    return curve_spans(curve);
  };
  BezierSurface surface;
  surface.patches = Grid<RationalBezierPatch>(1, 1);
  surface.patches(0, 0) = patch;
  surface.u_knots = surface.v_knots = {0, 1};
  ShapeModel model;
  for (const auto& [i, j] : {std::pair{0, 0}, {rows, 0}, {rows, columns}, {0, columns}})
    model.vertices.push_back(projected(patch.points(i, j)));
  model.edges = {{row(true, 0), 0, 1},
                 {row(false, rows), 1, 2},
                 {row(true, columns), 3, 2},
                 {row(false, 0), 0, 3}};
  ModelFace face;
  face.surface = surface;
  face.chart.corners = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  face.chart.borders = {line({0, 0}, {1, 0}, 0, 1), line({1, 0}, {1, 1}, 1, 2),
                        line({0, 1}, {1, 1}, 2, 3, true), line({0, 0}, {0, 1}, 3, 0, true)};
  face.edges = {0, 1, 2, 3};
  model.faces.push_back(face);
  return model;
}

// Degree 3, with heights drawn at random.
ShapeModel hilly(int seed) {
  auto random = testing::seeded(seed);
  constexpr int kDegree = 3;
  RationalBezierPatch patch{Grid<Vec4>(kDegree + 1, kDegree + 1)};
  for (int i = 0; i <= kDegree; ++i)
    for (int j = 0; j <= kDegree; ++j)
      patch.points(i, j) = {i / 3.0, j / 3.0, testing::uniform(random, -2, 2), 1};
  return whole_patch(patch);
}

// What a border is too far for, points inside cannot mend: they would come ever nearer to it.
TEST(ShapeFacets, HaveNoPointsInsideThatCrowdAtABorder) {
  for (int seed = 1; seed <= 20; ++seed)
    for (const double deviation : {0.1, 0.01}) {
      const ShapeFacets facets = shape_facets(hilly(seed), {.deviation = deviation, .angle = 0});
      const MeshedFace& face = facets.faces[0];
      EXPECT_EQ(face.obstacle, "");
      EXPECT_LE(facets.distance, deviation);
      double nearest = 1;
      for (const Vec2& uv : face.uv)
        for (const double off : {uv[0], uv[1], 1 - uv[0], 1 - uv[1]})
          if (off > 0) nearest = std::min(nearest, off);
      EXPECT_GT(nearest, 1e-3) << "seed " << seed << ", deviation " << deviation;
    }
}

TEST(ShapeFacets, EndWithinAFaceWhenTold) {
  int asked = 0;
  const ShapeFacets facets =
      shape_facets(sphere(2), {.deviation = 2e-4}, [&] { return ++asked < 4; });
  EXPECT_TRUE(facets.stopped);
  EXPECT_TRUE(facets.faces.empty());
}

TEST(ShapeFacets, DoNotDependOnTheNumberOfThreads) {
  ShapeFacets one, two;
  with_threads(1, [&] { one = shape_facets(sphere(2), {.deviation = 0.01}); });
  with_threads(2, [&] { two = shape_facets(sphere(2), {.deviation = 0.01}); });
  EXPECT_EQ(one.points, two.points);
  EXPECT_EQ(one.faces[0].triangles, two.faces[0].triangles);
}

// The square with an arc for its lower side, whose chord is y = 0, and a triangle for a hole.
ShapeModel holed(const std::array<Vec2, 3>& clockwise) {
  ShapeModel model = square();
  model.edges[0].curve = curve_spans(BezierCurve{{{0, 0, 0}, {0.5, -0.3, 0}, {1, 0, 0}}});
  ModelFace& face = model.faces[0];
  face.chart.borders[0].curve.spans = {{{{{0, 0, 1}, {0.5, -0.3, 1}, {1, 0, 1}}}, {0, 1}}};
  for (int k = 0; k < 3; ++k) {
    const Vec2 &a = clockwise[static_cast<std::size_t>(k)],
               &b = clockwise[static_cast<std::size_t>((k + 1) % 3)];
    model.vertices.push_back({a[0], a[1], 0});
    face.chart.corners.push_back(a);
    model.edges.push_back({straight({a[0], a[1], 0}, {b[0], b[1], 0}), 4 + k, 4 + (k + 1) % 3});
    face.chart.borders.push_back(line(a, b, 4 + k, 4 + (k + 1) % 3));
    face.edges.push_back(4 + k);
  }
  return model;
}

TEST(ShapeFacets, DivideArcsWhoseChordsCrossOtherBorders) {
  const ShapeFacets facets = shape_facets(holed({Vec2{0.4, 0.1}, Vec2{0.6, 0.1}, Vec2{0.5, -0.1}}),
                                          {.deviation = 10, .angle = 0});
  EXPECT_EQ(facets.faces[0].obstacle, "");
  EXPECT_NEAR(area(facets), 1 + 0.1 - 0.02, 0.04);  // the arc has an area of 2/3 * 0.15
}

TEST(ShapeFacets, DivideArcsWhoseChordsLeaveHolesOutside) {
  const ShapeFacets facets = shape_facets(
      holed({Vec2{0.4, -0.02}, Vec2{0.6, -0.02}, Vec2{0.5, -0.1}}), {.deviation = 10, .angle = 0});
  EXPECT_EQ(facets.faces[0].obstacle, "");
  EXPECT_NEAR(area(facets), 1 + 0.1 - 0.008, 0.04);
}

// A hole between an arc and its chord, both of which are within the deviation of the chord.
TEST(ShapeFacets, OfEdgesWithTheSameEndsHaveNoSideInCommon) {
  ShapeModel model = square();
  ModelFace& face = model.faces[0];
  const Vec2 a{0.4, 0.5}, b{0.6, 0.5};
  for (const Vec2& end : {a, b}) {
    model.vertices.push_back({end[0], end[1], 0});
    face.chart.corners.push_back(end);
  }
  model.edges.push_back(
      {curve_spans(BezierCurve{{{a[0], a[1], 0}, {0.5, 0.52, 0}, {b[0], b[1], 0}}}), 4, 5});
  RegionBorder arc = line(a, b, 4, 5);
  arc.curve.spans = {{{{{a[0], a[1], 1}, {0.5, 0.52, 1}, {b[0], b[1], 1}}}, {0, 1}}};
  face.chart.borders.push_back(arc);
  model.edges.push_back({straight({a[0], a[1], 0}, {b[0], b[1], 0}), 4, 5});
  face.chart.borders.push_back(line(a, b, 5, 4, true));
  face.edges.insert(face.edges.end(), {4, 5});
  const ShapeFacets facets = shape_facets(model, {.deviation = 1, .angle = 0});
  ASSERT_EQ(facets.faces[0].obstacle, "");
  EXPECT_EQ((side_uses(facets)[{4, 5}]), 1);
  EXPECT_LT(area(facets), 1 - 0.5 * 0.2 * 0.009);  // the hole is there
}

// Alike triangulations of two faces with the same borders have the same diagonals.
TEST(ShapeFacets, OfTwoFacesHaveNoDiagonalInCommon) {
  ShapeModel model = square();
  model.faces.push_back(model.faces[0]);
  const ShapeFacets facets = shape_facets(model, {.deviation = 1, .angle = 0});
  for (const auto& [side, uses] : side_uses(facets))
    EXPECT_EQ(uses, 2) << side.first << " " << side.second;
  EXPECT_DOUBLE_EQ(area(facets), 2);
  EXPECT_EQ(facets.faces[0].triangles.size(), 2u);
}

// The diagonal of the square is an edge of another face.
TEST(ShapeFacets, HaveNoDiagonalAlongAnotherFacesEdge) {
  ShapeModel model = square();
  const std::map<std::pair<int, int>, int> alone =
      side_uses(shape_facets(model, {.deviation = 1, .angle = 0}));
  const int from = alone.contains({0, 2}) ? 0 : 1;
  const int to = from + 2, third = from + 1;
  model.edges.push_back({straight(model.vertices[static_cast<std::size_t>(from)],
                                  model.vertices[static_cast<std::size_t>(to)]),
                         from, to});
  ModelFace half = model.faces[0];
  const auto corner = [&](int k) { return half.chart.corners[static_cast<std::size_t>(k)]; };
  half.chart.borders = {half.chart.borders[static_cast<std::size_t>(from)],
                        half.chart.borders[static_cast<std::size_t>(third)],
                        line(corner(from), corner(to), to, from, true)};
  half.edges = {from, third, 4};
  model.faces.push_back(half);
  const ShapeFacets facets = shape_facets(model, {.deviation = 1, .angle = 0});
  EXPECT_EQ((side_uses(facets)[{from, to}]), 1);
  EXPECT_DOUBLE_EQ(area(facets), 1.5);
}

TEST(ShapeFacets, SayWhichFaceHasCrossingBorders) {
  ShapeModel model = square();
  std::swap(model.faces[0].chart.corners[1], model.faces[0].chart.corners[2]);
  const ShapeFacets facets = shape_facets(model, {.deviation = 0.1});
  EXPECT_NE(facets.faces[0].obstacle, "");
  EXPECT_TRUE(facets.faces[0].triangles.empty());
}

TEST(ShapeFacets, SayWhichFaceHasBordersWithGaps) {
  ShapeModel model = roof();
  model.faces[0].chart.borders[0].curve = planar_line({0, 0}, {0.5, 0}, {0, 1});
  const ShapeFacets facets = shape_facets(model, {.deviation = 0.005});
  EXPECT_EQ(facets.faces[0].obstacle, "its borders have gaps on its surface");
  EXPECT_TRUE(facets.faces[0].triangles.empty());
}

TEST(ShapeFacets, StopWhenTheyAreTold) {
  EXPECT_TRUE(shape_facets(square(), {.deviation = 0.1}, [] { return false; }).stopped);
}

TEST(ShapeFacets, RefuseWhatIsNoDeviation) {
  EXPECT_THROW(shape_facets(square(), {.deviation = 0}), InvalidInput);
  EXPECT_THROW(shape_facets(square(), {.deviation = std::nan("")}), InvalidInput);
  EXPECT_THROW(shape_facets(square(), {.deviation = 1, .angle = -1}), InvalidInput);
  ShapeModel model = square();
  model.faces[0].edges[2] = 9;
  EXPECT_THROW(shape_facets(model, {.deviation = 1}), InvalidInput);
}

}  // namespace
}  // namespace blossom
