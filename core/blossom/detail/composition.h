// SPDX-License-Identifier: LGPL-2.1-or-later
// A tensor-product patch along a curve of its parameters, over any scalar.

#pragma once

#include <vector>

#include "core/math/detail/scaled_bernstein.h"
#include "core/math/vec.h"

namespace blossom::detail {

/// The four forms whose products weigh the control points, as scaled Bernstein coefficients of
/// one degree: 1 - u, u, 1 - v, v along the curve, times its weight where it is rational.
template <class Scalar>
struct ParameterForms {
  std::vector<Scalar> u0, u1, v0, v1;
};

template <class Scalar>
ParameterForms<Scalar> parameter_forms(const std::vector<Vec<Scalar, 2>>& curve) {
  ParameterForms<Scalar> forms;
  for (const Vec<Scalar, 2>& uv : curve) {
    forms.u0.push_back(Scalar(1) - uv[0]);
    forms.u1.push_back(uv[0]);
    forms.v0.push_back(Scalar(1) - uv[1]);
    forms.v1.push_back(uv[1]);
  }
  return forms;
}

/// Of a rational curve, points (wu, wv, w).
template <class Scalar>
ParameterForms<Scalar> parameter_forms(const std::vector<Vec<Scalar, 3>>& curve) {
  ParameterForms<Scalar> forms;
  for (const Vec<Scalar, 3>& uv : curve) {
    forms.u0.push_back(uv[2] - uv[0]);
    forms.u1.push_back(uv[0]);
    forms.v0.push_back(uv[2] - uv[1]);
    forms.v1.push_back(uv[1]);
  }
  return forms;
}

/// Rows (k, j) of coordinate k: sum_i binom(n, i) binom(m, j) P_ij (1 - u)^(n - i) u^i, scaled;
/// (dimension) (m + 1) x (n d + 1).
template <class Point>
Grid<scalar_of<Point>> composed_in_u(const Grid<Point>& net,
                                     const Grid<scalar_of<Point>>& powers_u) {
  using Scalar = scalar_of<Point>;
  const int n = net.rows() - 1, m = net.columns() - 1, length = powers_u.columns();
  Grid<Scalar> result(dimension_of<Point> * (m + 1), length, Scalar(0));
  for (int k = 0; k < dimension_of<Point>; ++k)
    for (int j = 0; j <= m; ++j) {
      const std::span<Scalar> row = row_of(result, k * (m + 1) + j);
      for (int i = 0; i <= n; ++i) {
        const std::span<const Scalar> power = row_of(powers_u, i);
        const Scalar weight(binomial(n, i) * binomial(m, j));
        const Scalar point = coordinate(net(i, j), k) * weight;
        for (std::size_t l = 0; l < row.size(); ++l) row[l] += power[l] * point;
      }
    }
  return result;
}

/// The Bezier points of degree d (n + m) of the patch along the curve:
///
///   sum_ij P_ij binom(n, i) (1 - u)^(n - i) u^i binom(m, j) (1 - v)^(m - j) v^j
///
/// with all powers and products as Bernstein forms.
template <class Point>
std::vector<Point> composition(const Grid<Point>& net, const ParameterForms<scalar_of<Point>>& in) {
  using Scalar = scalar_of<Point>;
  const int n = net.rows() - 1, m = net.columns() - 1;
  const auto powers_of = [](const std::vector<Scalar>& a, const std::vector<Scalar>& b, int count) {
    const std::vector<Scalar> from = scaled(std::span(a)), to = scaled(std::span(b));
    return mixed_powers(std::span(from), std::span(to), count);
  };
  const Grid<Scalar> rows = composed_in_u(net, powers_of(in.u0, in.u1, n));
  const Grid<Scalar> powers_v = powers_of(in.v0, in.v1, m);
  Grid<Scalar> sums(dimension_of<Point>, rows.columns() + powers_v.columns() - 1, Scalar(0));
  for (int k = 0; k < dimension_of<Point>; ++k)
    for (int j = 0; j <= m; ++j)
      add_product(row_of(rows, k * (m + 1) + j), row_of(powers_v, j), row_of(sums, k));
  std::vector<Point> points(index(sums.columns()));
  for (int k = 0; k < dimension_of<Point>; ++k)
    for (int l = 0; l < sums.columns(); ++l) coordinate(points[index(l)], k) = sums(k, l);
  return unscaled(std::move(points));
}

}  // namespace blossom::detail
