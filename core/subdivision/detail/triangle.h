// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangles out of tensor-product nets, over any scalar.

#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "core/forms/triangle.h"
#include "core/math/convolution.h"
#include "core/math/detail/bernstein.h"
#include "core/math/matrix.h"

namespace blossom::detail {

/// Row (i, j) at its place in a triangle: the blossoms of B_0^n .. B_n^n at i copies of a, j of b
/// and n - i - j of c.
template <class Scalar>
Grid<Scalar> corner_matrix(int n, const Scalar& a, const Scalar& b, const Scalar& c) {
  using Triangle = BezierTriangleOf<Scalar>;
  Grid<Scalar> matrix(static_cast<int>(Triangle::count(n)), n + 1, Scalar(0));
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) {
      using Factor = std::span<const Scalar>;
      const std::vector<Scalar> at_a = bernstein(i, a), at_b = bernstein(j, b);
      std::vector<Scalar> both(index(i + j + 1), Scalar(0));
      add_product(Factor(at_a), Factor(at_b), std::span<Scalar>(both));
      const std::vector<Scalar> at_c = bernstein(n - i - j, c);
      add_product(Factor(both), Factor(at_c),
                  row_of(matrix, static_cast<int>(Triangle::index(n, i, j))));
    }
  return matrix;
}

/// Points of the triangle of degree n + m from the (n + 1) x (m + 1) net.
template <class Point>
std::vector<Point> triangle_from_net(
    const Grid<Point>& net, const std::array<Vec<typename Point::scalar_type, 2>, 3>& corners) {
  using Scalar = typename Point::scalar_type;
  using Triangle = BezierTriangleOf<Point>;
  const int n = net.rows() - 1, m = net.columns() - 1, degree = n + m;
  const auto& [a, b, c] = corners;
  const Grid<Point> values = product_transposed(product(corner_matrix(n, a[0], b[0], c[0]), net),
                                                corner_matrix(m, a[1], b[1], c[1]));
  std::vector<Point> points;
  for (int nu = 0; nu <= degree; ++nu)
    for (int mu = 0; nu + mu <= degree; ++mu) {
      const int lambda = degree - nu - mu;
      Point sum{};
      for (int i = std::max(0, nu - m); i <= std::min(nu, n); ++i)
        for (int j = std::max(0, n - i - lambda); j <= std::min(mu, n - i); ++j) {
          if (nu - i + mu - j > m) continue;
          const double count = binomial(nu, i) * binomial(mu, j) * binomial(lambda, n - i - j);
          sum += values(static_cast<int>(Triangle::index(n, i, j)),
                        static_cast<int>(Triangle::index(m, nu - i, mu - j))) *
                 Scalar(count);
        }
      points.push_back(sum * (Scalar(1) / Scalar(binomial(degree, n))));
    }
  return points;
}

}  // namespace blossom::detail
