// SPDX-License-Identifier: LGPL-2.1-or-later
// Facets where the parameters of a surface turn within it.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/math/binomial.h"
#include "core/tessellation/shape_facets.h"
#include "tests/support/region_lines.h"

namespace blossom {
namespace {

using testing::line;

// Of polynomials by their Bezier points.
std::vector<double> product(const std::vector<double>& a, const std::vector<double>& b) {
  const int n = static_cast<int>(a.size()) - 1, m = static_cast<int>(b.size()) - 1;
  std::vector<double> c(static_cast<std::size_t>(n + m) + 1, 0);
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= m; ++j)
      c[static_cast<std::size_t>(i + j)] +=
          binomial(n, i) * binomial(m, j) / binomial(n + m, i + j) *
          a[static_cast<std::size_t>(i)] * b[static_cast<std::size_t>(j)];
  return c;
}

// A band of z = x^2 / 10, 6 wide and 20 long, whose parameters slide by 6 across it within
// `length` of its middle, as those of a pipe do where its sections turn: x = 6 u + w(v), with w
// smooth.
ShapeModel sliding(double length) {
  const std::vector<double> ends{0, 10, 10 + length, 20}, one(4, 1);
  const std::array<std::vector<double>, 3> slides{
      std::vector<double>{0, 0, 0, 0}, {0, 0, 6, 6}, {6, 6, 6, 6}};
  BezierSurface surface;
  surface.u_knots = {0, 1};
  surface.v_knots = ends;
  surface.patches = Grid<RationalBezierPatch>(1, 3);
  std::array<CurveSpans, 2> sides;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::vector<double> w = product(slides[k], one), squared = product(slides[k], slides[k]);
    const std::vector<double> y = product({ends[k], ends[k + 1]}, std::vector<double>(6, 1));
    Grid<Vec4>& net = surface.patches(0, static_cast<int>(k)).points;
    net = Grid<Vec4>(3, 7);
    for (int i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 7; ++j) {
        const double u = 3 * i, u_squared = i == 2 ? 36 : 0;
        net(i, static_cast<int>(j)) = {u + w[j], y[j], (u_squared + 2 * u * w[j] + squared[j]) / 10,
                                       1};
      }
    for (int side = 0; side < 2; ++side) {
      CurveSpan span;
      for (int j = 0; j < 7; ++j) span.curve.points.push_back(net(2 * side, j));
      span.place = {ends[k], ends[k + 1]};
      sides[static_cast<std::size_t>(side)].spans.push_back(span);
    }
  }
  const auto arch = [&](int patch, int j) {
    BezierCurve curve;
    for (int i = 0; i < 3; ++i)
      curve.points.push_back(projected(surface.patches(0, patch).points(i, j)));
    return curve;
  };
  const BezierCurve from = arch(0, 0), to = arch(2, 6);
  ShapeModel model;
  model.vertices = {from.points[0], from.points[2], to.points[2], to.points[0]};
  model.edges = {
      {curve_spans(from), 0, 1}, {sides[1], 1, 2}, {curve_spans(to), 3, 2}, {sides[0], 0, 3}};
  ModelFace face;
  face.surface = surface;
  face.chart.corners = {{0, 0}, {1, 0}, {1, 20}, {0, 20}};
  face.chart.borders = {line({0, 0}, {1, 0}, 0, 1), line({1, 0}, {1, 20}, 1, 2),
                        line({0, 20}, {1, 20}, 2, 3, true), line({0, 0}, {0, 20}, 3, 0, true)};
  face.chart.borders[1].curve = planar_line({1, 0}, {1, 20}, {0, 20});
  face.chart.borders[3].curve = planar_line({0, 0}, {0, 20}, {0, 20});
  face.edges = {0, 1, 2, 3};
  model.faces.push_back(face);
  return model;
}

// Its parameters turn within the surface, which no distance counts.
TEST(FoldedFacets, AreDividedWhereParametersTurnAlongTheSurface) {
  for (const double deviation : {0.1, 0.03}) {
    const ShapeFacets facets = shape_facets(sliding(2), {.deviation = deviation, .angle = 0});
    EXPECT_EQ(facets.faces[0].obstacle, "");
    EXPECT_EQ(facets.faces[0].folded, 0) << facets.faces[0].triangles.size();
    EXPECT_LE(facets.distance, deviation);
  }
}

}  // namespace
}  // namespace blossom
