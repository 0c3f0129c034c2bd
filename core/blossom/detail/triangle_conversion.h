// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangular patches as tensor-product patches, over any scalar.

#pragma once

#include <array>

#include "core/blossom/detail/checks.h"
#include "core/forms/algebra/detail/products.h"

namespace blossom::detail {

/// Points of row i of the collapsed patch before elevation: q_{i 0}, q_{i-1 1}, .., q_{0 i}.
template <class Point>
std::vector<Point> layer(const BezierTriangleOf<Point>& triangle, int i) {
  std::vector<Point> points;
  for (int mu = 0; mu <= i; ++mu) points.push_back(triangle(i - mu, mu));
  return points;
}

/// T(u (1 - v), u v): row i is layer i, its degree raised from i to N.
template <class Point>
Grid<Point> collapsed_net(const BezierTriangleOf<Point>& triangle) {
  const int n = triangle.degree;
  Grid<Point> net(n + 1, n + 1);
  for (int i = 0; i <= n; ++i) {
    const Grid<Point> row = elevated_net(one_row(layer(triangle, i)), 0, n - i);
    for (int j = 0; j <= n; ++j) net(i, j) = row(0, j);
  }
  return net;
}

/// T(u, v), bidegree (N, N): see half_patch. Cost O(N^4).
template <class Point>
Grid<Point> half_net(const BezierTriangleOf<Point>& triangle) {
  using Scalar = scalar_of<Point>;
  const int n = triangle.degree;
  Grid<Point> net(n + 1, n + 1, Point{});
  BezierTriangleOf<Point> after = triangle;  // with m parameters (1, 1)
  for (int m = 0; m <= n; ++m) {
    for (int i = m; i <= n; ++i)
      for (int j = m; i + j <= n + m; ++j)
        net(i, j) += after(i - m, j - m) *
                     (Scalar(binomial(i, m) * binomial(n - i, j - m)) / Scalar(binomial(n, j)));
    if (m < n) after = blossom_step(after, Vec<Scalar, 2>{Scalar(1), Scalar(1)});
  }
  return net;
}

/// Corners of a quadrilateral in the triangle's barycentric (x, y): at (0, 0), (0, 1), (1, 0),
/// (1, 1) of the new parameters.
template <class Scalar>
using QuadCorners = std::array<Vec<Scalar, 2>, 4>;

/// T on a quadrilateral with the bilinear map between its corners, bidegree (N, N):
///
///   p_ij = sum_{a+b+c+d=N, c+d=i, b+d=j} N! / (a! b! c! d!) / (binom(N, i) binom(N, j))
///          t(k_00^a, k_01^b, k_10^c, k_11^d)
///
/// with the blossom t of the triangle. Source: DeRose, Goldman, Hagen, Mann 1993.
template <class Point>
Grid<Point> quad_net(const BezierTriangleOf<Point>& triangle,
                     const QuadCorners<scalar_of<Point>>& corners) {
  using Scalar = scalar_of<Point>;
  const int n = triangle.degree;
  Grid<Point> net(n + 1, n + 1, Point{});
  BezierTriangleOf<Point> after_d = triangle;
  for (int d = 0; d <= n; ++d) {
    BezierTriangleOf<Point> after_c = after_d;
    for (int c = 0; c + d <= n; ++c) {
      BezierTriangleOf<Point> after_b = after_c;
      for (int b = 0; b + c + d <= n; ++b) {
        BezierTriangleOf<Point> value = after_b;
        while (value.degree > 0) value = blossom_step(value, corners[0]);
        // N! / (a! b! c! d!) over binom(N, c + d): below binom(N, c + d), so exact up to N = 25.
        const Scalar count(binomial(c + d, d) * binomial(n - c - d, b));
        net(c + d, b + d) += value.points[0] * count;
        if (after_b.degree > 0) after_b = blossom_step(after_b, corners[1]);
      }
      if (after_c.degree > 0) after_c = blossom_step(after_c, corners[2]);
    }
    if (after_d.degree > 0) after_d = blossom_step(after_d, corners[3]);
  }
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) net(i, j) *= Scalar(1) / Scalar(binomial(n, j));
  return net;
}

}  // namespace blossom::detail
