// SPDX-License-Identifier: LGPL-2.1-or-later
// Derivatives of Bezier forms as Bezier forms, over any scalar. A curve is a net with one row.

#pragma once

#include "core/forms/detail/products.h"

namespace blossom::detail {

/// One derivative along u: n (p_(i+1) - p_i). A constant gives a constant 0.
template <class T>
Grid<T> derivative_along_u(const Grid<T>& net) {
  using Scalar = scalar_of<T>;
  const int n = net.rows() - 1;
  if (n == 0) return Grid<T>(1, net.columns(), T{});
  Grid<T> result(n, net.columns());
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < net.columns(); ++j) result(i, j) = (net(i + 1, j) - net(i, j)) * Scalar(n);
  return result;
}

template <class T>
Grid<T> derivative_along_v(const Grid<T>& net) {
  using Scalar = scalar_of<T>;
  const int m = net.columns() - 1;
  if (m == 0) return Grid<T>(net.rows(), 1, T{});
  Grid<T> result(net.rows(), m);
  for (int i = 0; i < net.rows(); ++i)
    for (int j = 0; j < m; ++j) result(i, j) = (net(i, j + 1) - net(i, j)) * Scalar(m);
  return result;
}

template <class T>
Grid<T> derivative_net(Grid<T> net, int order_u, int order_v) {
  for (; order_u > 0; --order_u) net = derivative_along_u(net);
  for (; order_v > 0; --order_v) net = derivative_along_v(net);
  return net;
}

/// One derivative of a triangle along barycentric x: N (q_{nu+1 mu} - q_{nu mu}).
template <class Point>
BezierTriangleOf<Point> derivative_along_x(const BezierTriangleOf<Point>& triangle) {
  using Scalar = scalar_of<Point>;
  const int n = triangle.degree;
  if (n == 0) return {0, {Point{}}};
  BezierTriangleOf<Point> result{n - 1, {}};
  for (int nu = 0; nu < n; ++nu)
    for (int mu = 0; nu + mu < n; ++mu)
      result.points.push_back((triangle(nu + 1, mu) - triangle(nu, mu)) * Scalar(n));
  return result;
}

template <class Point>
BezierTriangleOf<Point> derivative_along_y(const BezierTriangleOf<Point>& triangle) {
  using Scalar = scalar_of<Point>;
  const int n = triangle.degree;
  if (n == 0) return {0, {Point{}}};
  BezierTriangleOf<Point> result{n - 1, {}};
  for (int nu = 0; nu < n; ++nu)
    for (int mu = 0; nu + mu < n; ++mu)
      result.points.push_back((triangle(nu, mu + 1) - triangle(nu, mu)) * Scalar(n));
  return result;
}

/// X and w of homogeneous points.
template <class Scalar>
struct HomogeneousNet {
  Grid<Vec<Scalar, 3>> numerator;
  Grid<Scalar> weight;
};

template <class Scalar>
HomogeneousNet<Scalar> parts_of(const Grid<Vec<Scalar, 4>>& net) {
  HomogeneousNet<Scalar> parts{{net.rows(), net.columns()}, {net.rows(), net.columns(), Scalar(0)}};
  for (int i = 0; i < net.rows(); ++i)
    for (int j = 0; j < net.columns(); ++j) {
      parts.numerator(i, j) = {net(i, j)[0], net(i, j)[1], net(i, j)[2]};
      parts.weight(i, j) = net(i, j)[3];
    }
  return parts;
}

template <class Scalar>
Grid<Vec<Scalar, 4>> joined(const HomogeneousNet<Scalar>& parts) {
  Grid<Vec<Scalar, 4>> net(parts.weight.rows(), parts.weight.columns());
  for (int i = 0; i < net.rows(); ++i)
    for (int j = 0; j < net.columns(); ++j) {
      const Vec<Scalar, 3>& x = parts.numerator(i, j);
      net(i, j) = {x[0], x[1], x[2], parts.weight(i, j)};
    }
  return net;
}

/// With S = X / w^k in `numerator`: the numerator over w^(k + 1) of its derivative,
/// w X' - k w' X, along u or along v.
template <class Scalar>
Grid<Vec<Scalar, 3>> quotient_derivative(const Grid<Vec<Scalar, 3>>& numerator,
                                         const Grid<Scalar>& weight, int k, bool along_u) {
  const int u = along_u ? 1 : 0, v = 1 - u;
  Grid<Vec<Scalar, 3>> result = scalar_product(weight, derivative_net(numerator, u, v));
  const Grid<Vec<Scalar, 3>> other = scalar_product(derivative_net(weight, u, v), numerator);
  for (int i = 0; i < result.rows(); ++i)
    for (int j = 0; j < result.columns(); ++j) result(i, j) -= other(i, j) * Scalar(k);
  return result;
}

/// A partial derivative of X / w as a homogeneous net over w^(order + 1).
template <class Scalar>
Grid<Vec<Scalar, 4>> rational_derivative_net(const Grid<Vec<Scalar, 4>>& net, int order_u,
                                             int order_v) {
  const auto [start, weight] = parts_of(net);
  HomogeneousNet<Scalar> parts{start, weight};
  for (int k = 1; k <= order_u + order_v; ++k) {
    parts.numerator = quotient_derivative(parts.numerator, weight, k, k <= order_u);
    parts.weight = scalar_product(weight, parts.weight);
  }
  parts.numerator = elevated_net(parts.numerator, parts.weight.rows() - parts.numerator.rows(),
                                 parts.weight.columns() - parts.numerator.columns());
  return joined(parts);
}

}  // namespace blossom::detail
