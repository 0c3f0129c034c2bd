// SPDX-License-Identifier: LGPL-2.1-or-later
// Derivatives of Bezier forms as Bezier forms, over any scalar. A curve is a net with one row.

#pragma once

#include <algorithm>
#include <span>
#include <type_traits>

#include "core/forms/algebra/detail/products.h"

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

/// The parameter of a derivative: u or v of nets, the barycentric x or y of triangles.
enum class By { U, V };

template <class T>
Grid<T> one_derivative(const Grid<T>& net, By by) {
  return by == By::U ? derivative_along_u(net) : derivative_along_v(net);
}

/// N (q_{nu+1 mu} - q_{nu mu}) along x, N (q_{nu mu+1} - q_{nu mu}) along y.
template <class Point>
BezierTriangleOf<Point> one_derivative(const BezierTriangleOf<Point>& triangle, By by) {
  using Scalar = scalar_of<Point>;
  const int n = triangle.degree;
  const int x = by == By::U ? 1 : 0, y = 1 - x;
  if (n == 0) return {0, {Point{}}};
  BezierTriangleOf<Point> result{n - 1, {}};
  for (int nu = 0; nu < n; ++nu)
    for (int mu = 0; nu + mu < n; ++mu)
      result.points.push_back((triangle(nu + x, mu + y) - triangle(nu, mu)) * Scalar(n));
  return result;
}

/// A form with other points at the same places: point(p) for each point p.
template <class T, class Function>
auto mapped(const Grid<T>& net, Function point) {
  Grid<decltype(point(net(0, 0)))> result(net.rows(), net.columns());
  std::ranges::transform(net.values(), result.values().begin(), point);
  return result;
}

template <class T, class Function>
auto mapped(const BezierTriangleOf<T>& triangle, Function point) {
  BezierTriangleOf<decltype(point(triangle.points[0]))> result{triangle.degree, {}};
  for (const T& value : triangle.points) result.points.push_back(point(value));
  return result;
}

template <class T>
std::span<T> values_of(Grid<T>& net) {
  return net.values();
}

template <class T>
std::span<T> values_of(BezierTriangleOf<T>& triangle) {
  return triangle.points;
}

/// X and w of a form of homogeneous points.
template <class Form>
auto parts_of(const Form& form) {
  const auto point = [](const auto& p) {
    return Vec<std::decay_t<decltype(p[0])>, 3>{p[0], p[1], p[2]};
  };
  const auto last = [](const auto& p) { return p[3]; };
  struct Parts {
    decltype(mapped(form, point)) numerator;
    decltype(mapped(form, last)) weight;
  };
  return Parts{mapped(form, point), mapped(form, last)};
}

/// The form of homogeneous points from X and w of the same degree.
template <class Numerator, class Weight>
auto joined(const Numerator& numerator, Weight weight) {
  auto result = mapped(numerator, [](const auto& x) {
    return Vec<std::decay_t<decltype(x[0])>, 4>{x[0], x[1], x[2], x[0]};
  });
  const auto points = values_of(result);
  const auto weights = values_of(weight);
  for (std::size_t i = 0; i < points.size(); ++i) points[i][3] = weights[i];
  return result;
}

/// The same form with the degree of another one.
template <class T, class U>
Grid<T> raised_to(const Grid<T>& net, const Grid<U>& other) {
  return elevated_net(net, other.rows() - net.rows(), other.columns() - net.columns());
}

template <class T, class U>
BezierTriangleOf<T> raised_to(BezierTriangleOf<T> triangle, const BezierTriangleOf<U>& other) {
  while (triangle.degree < other.degree) triangle = elevated_once(triangle);
  return triangle;
}

/// With S = X / w^k in `numerator`: the numerator over w^(k + 1) of its derivative,
/// w X' - k w' X.
template <class Numerator, class Weight>
Numerator quotient_derivative(const Numerator& numerator, const Weight& weight, int k, By by) {
  Numerator result = scalar_product(weight, one_derivative(numerator, by));
  Numerator other = scalar_product(one_derivative(weight, by), numerator);
  const auto values = values_of(result), others = values_of(other);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] -= others[i] * scalar_of<std::decay_t<decltype(others[i])>>(k);
  return result;
}

/// A partial derivative of X / w as a homogeneous form over w^(order + 1).
///
/// form         a Grid or a BezierTriangleOf of homogeneous points
template <class Form>
Form rational_derivative(const Form& form, int order_u, int order_v) {
  const auto [start, weight] = parts_of(form);
  auto numerator = start;
  auto power = weight;
  for (int k = 1; k <= order_u + order_v; ++k) {
    numerator = quotient_derivative(numerator, weight, k, k <= order_u ? By::U : By::V);
    power = scalar_product(weight, power);
  }
  return joined(raised_to(numerator, power), power);
}

}  // namespace blossom::detail
