// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangular Bezier patches.

#pragma once

#include <cstddef>
#include <vector>

#include "core/math/vec.h"

namespace blossom {

/// T(x, y) = sum q_{nu mu} B^N_{nu mu}(x, y) over nu + mu <= N, where barycentric x belongs to the
/// vertex a, y to b and 1 - x - y to c; (N + 1)(N + 2) / 2 points.
/// Index convention: nu counts a, mu counts b, N - nu - mu counts c; corners q_{N0} = T at a,
/// q_{0N} = T at b, q_{00} = T at c.
template <class Point>
struct BezierTriangleOf {
  int degree = 0;
  std::vector<Point> points;

  /// Place of q_{nu mu} in `points`: nu = 0 first, then growing mu.
  static std::size_t index(int degree, int nu, int mu) {
    return static_cast<std::size_t>(nu * (degree + 1) - nu * (nu - 1) / 2 + mu);
  }
  static std::size_t count(int degree) {
    return static_cast<std::size_t>((degree + 1) * (degree + 2) / 2);
  }
  Point& operator()(int nu, int mu) { return points[index(degree, nu, mu)]; }
  const Point& operator()(int nu, int mu) const { return points[index(degree, nu, mu)]; }
  friend bool operator==(const BezierTriangleOf&, const BezierTriangleOf&) = default;
};

using BezierTriangle = BezierTriangleOf<Vec3>;
using RationalBezierTriangle = BezierTriangleOf<Vec4>;

}  // namespace blossom
