// SPDX-License-Identifier: LGPL-2.1-or-later
// Uniform cubic B-spline surfaces and surfaces swept by translation, as Bezier patches.

#pragma once

#include <array>
#include <vector>

#include "core/forms/surface.h"
#include "core/math/vec.h"

namespace blossom::testing {

/// The Bezier points of span i of a uniform cubic B-spline from its four control points.
inline std::array<Vec3, 4> uniform_span(const std::array<Vec3, 4>& p) {
  return {(p[0] + 4 * p[1] + p[2]) * (1.0 / 6), (2 * p[1] + p[2]) * (1.0 / 3),
          (p[1] + 2 * p[2]) * (1.0 / 3), (p[1] + 4 * p[2] + p[3]) * (1.0 / 6)};
}

/// The bicubic surface of a net; a closed direction takes the net's points round and round.
inline BezierSurface uniform_cubic(const Grid<Vec3>& net, bool closed_u, bool closed_v) {
  const int spans_u = closed_u ? net.rows() : net.rows() - 3;
  const int spans_v = closed_v ? net.columns() : net.columns() - 3;
  BezierSurface surface;
  for (int i = 0; i <= spans_u; ++i) surface.u_knots.push_back(i);
  for (int j = 0; j <= spans_v; ++j) surface.v_knots.push_back(j);
  surface.closed_u = closed_u;
  surface.closed_v = closed_v;
  surface.patches = Grid<RationalBezierPatch>(spans_u, spans_v);
  for (int i = 0; i < spans_u; ++i)
    for (int j = 0; j < spans_v; ++j) {
      std::array<std::array<Vec3, 4>, 4> rows;  // by u, Bezier points along v
      for (std::size_t k = 0; k < 4; ++k) {
        std::array<Vec3, 4> row;
        for (std::size_t l = 0; l < 4; ++l)
          row[l] = net((i + static_cast<int>(k)) % net.rows(),
                       (j + static_cast<int>(l)) % net.columns());
        rows[k] = uniform_span(row);
      }
      Grid<Vec4>& points = surface.patches(i, j).points = Grid<Vec4>(4, 4);
      for (std::size_t l = 0; l < 4; ++l) {
        const auto column = uniform_span({rows[0][l], rows[1][l], rows[2][l], rows[3][l]});
        for (std::size_t k = 0; k < 4; ++k)
          points(static_cast<int>(k), static_cast<int>(l)) = {column[k][0], column[k][1],
                                                              column[k][2], 1};
      }
    }
  return surface;
}

/// A Bezier curve moved along a vector: u along the curve, v along the vector.
inline BezierSurface extruded(const std::vector<Vec3>& curve, const Vec3& along) {
  BezierSurface surface{{0, 1}, {0, 1}};
  RationalBezierPatch patch{Grid<Vec4>(static_cast<int>(curve.size()), 2)};
  for (int i = 0; i < patch.points.rows(); ++i) {
    const Vec3 p = curve[static_cast<std::size_t>(i)], q = p + along;
    patch.points(i, 0) = {p[0], p[1], p[2], 1};
    patch.points(i, 1) = {q[0], q[1], q[2], 1};
  }
  surface.patches = Grid<RationalBezierPatch>(1, 1, patch);
  return surface;
}

}  // namespace blossom::testing
