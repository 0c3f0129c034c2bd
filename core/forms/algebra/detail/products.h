// SPDX-License-Identifier: LGPL-2.1-or-later
// Products and elevation of Bernstein forms, over any scalar. A curve is a net with one row.

#pragma once

#include <algorithm>
#include <vector>

#include "core/forms/triangle.h"
#include "core/math/detail/scaled_bernstein.h"

namespace blossom::detail {

template <class T>
Grid<T> one_row(const std::vector<T>& line) {
  Grid<T> net(1, static_cast<int>(line.size()));
  std::copy(line.begin(), line.end(), net.values().begin());
  return net;
}

template <class T>
std::vector<T> only_row(const Grid<T>& net) {
  return {net.values().begin(), net.values().end()};
}

/// c_ij binom(n, i) binom(m, j): at most 4 roundings each, 1 for n and m up to kMaxDegree.
template <class T>
Grid<T> scaled_net(Grid<T> net) {
  using Scalar = scalar_of<T>;
  const int n = net.rows() - 1, m = net.columns() - 1;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= m; ++j)
      net(i, j) *= Scalar(binomial_as<Scalar>(n, i) * binomial_as<Scalar>(m, j));
  return net;
}

/// The way back: at most 5 roundings each.
template <class T>
Grid<T> unscaled_net(Grid<T> net) {
  using Scalar = scalar_of<T>;
  const int n = net.rows() - 1, m = net.columns() - 1;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= m; ++j)
      net(i, j) *= Scalar(1) / Scalar(binomial_as<Scalar>(n, i) * binomial_as<Scalar>(m, j));
  return net;
}

/// The form of multiply(f, g), where `multiply` is linear in both.
///
///   h_kl = sum_ij binom(n, i) binom(n', k - i) / binom(n + n', k) .. f_ij g_(k - i)(l - j)
///
/// The weights of a sum are positive and add up to 1. Source: Farouki and Rajan 1988.
template <class T, class U, class Multiply>
auto bernstein_product(const Grid<T>& f, const Grid<U>& g, Multiply multiply) {
  using Product = decltype(multiply(f(0, 0), g(0, 0)));
  const Grid<T> a = scaled_net(f);
  const Grid<U> b = scaled_net(g);
  Grid<Product> sum(f.rows() + g.rows() - 1, f.columns() + g.columns() - 1, Product{});
  for (int i = 0; i < a.rows(); ++i)
    for (int j = 0; j < a.columns(); ++j)
      for (int k = 0; k < b.rows(); ++k)
        for (int l = 0; l < b.columns(); ++l) sum(i + k, j + l) += multiply(a(i, j), b(k, l));
  return unscaled_net(std::move(sum));
}

/// f g for a scalar form f.
template <class Scalar, class T>
Grid<T> scalar_product(const Grid<Scalar>& f, const Grid<T>& g) {
  return bernstein_product(f, g, [](const Scalar& s, const T& t) -> T { return t * s; });
}

/// N! / (nu! mu! (N - nu - mu)!): at most 3 roundings, none up to kMaxDegree.
template <class Scalar>
Scalar trinomial_as(int n, int nu, int mu) {
  return binomial_as<Scalar>(n, nu) * binomial_as<Scalar>(n - nu, mu);
}

template <class T>
BezierTriangleOf<T> scaled_triangle(BezierTriangleOf<T> triangle) {
  using Scalar = scalar_of<T>;
  for (int nu = 0; nu <= triangle.degree; ++nu)
    for (int mu = 0; nu + mu <= triangle.degree; ++mu)
      triangle(nu, mu) *= trinomial_as<Scalar>(triangle.degree, nu, mu);
  return triangle;
}

template <class T>
BezierTriangleOf<T> unscaled_triangle(BezierTriangleOf<T> triangle) {
  using Scalar = scalar_of<T>;
  for (int nu = 0; nu <= triangle.degree; ++nu)
    for (int mu = 0; nu + mu <= triangle.degree; ++mu)
      triangle(nu, mu) *= Scalar(Scalar(1) / trinomial_as<Scalar>(triangle.degree, nu, mu));
  return triangle;
}

/// f g of triangles, the same sum over the multi-indices of both. Source: DeRose 1988.
template <class Scalar, class T>
BezierTriangleOf<T> scalar_product(const BezierTriangleOf<Scalar>& f,
                                   const BezierTriangleOf<T>& g) {
  const BezierTriangleOf<Scalar> a = scaled_triangle(f);
  const BezierTriangleOf<T> b = scaled_triangle(g);
  const int degree = f.degree + g.degree;
  BezierTriangleOf<T> sum{degree, std::vector<T>(BezierTriangleOf<T>::count(degree), T{})};
  for (int i = 0; i <= f.degree; ++i)
    for (int j = 0; i + j <= f.degree; ++j)
      for (int k = 0; k <= g.degree; ++k)
        for (int l = 0; k + l <= g.degree; ++l) sum(i + k, j + l) += b(k, l) * a(i, j);
  return unscaled_triangle(std::move(sum));
}

template <class Scalar>
Grid<Vec<Scalar, 3>> cross_product(const Grid<Vec<Scalar, 3>>& f, const Grid<Vec<Scalar, 3>>& g) {
  return bernstein_product(f, g, cross<Scalar>);
}

template <class Scalar, int Dim>
Grid<Scalar> dot_product(const Grid<Vec<Scalar, Dim>>& f, const Grid<Vec<Scalar, Dim>>& g) {
  return bernstein_product(f, g, dot<Scalar, Dim>);
}

/// The same form with degrees higher by `more_u` and `more_v`: its product with 1.
template <class T>
Grid<T> elevated_net(const Grid<T>& net, int more_u, int more_v) {
  using Scalar = scalar_of<T>;
  return scalar_product(Grid<Scalar>(more_u + 1, more_v + 1, Scalar(1)), net);
}

/// A triangle of one degree more.
///   q'_{nu mu} = (nu q_{nu-1 mu} + mu q_{nu mu-1} + lambda q_{nu mu}) / (N + 1)
template <class Point>
BezierTriangleOf<Point> elevated_once(const BezierTriangleOf<Point>& triangle) {
  using Scalar = scalar_of<Point>;
  const int degree = triangle.degree + 1;
  BezierTriangleOf<Point> result{degree, {}};
  for (int nu = 0; nu <= degree; ++nu)
    for (int mu = 0; nu + mu <= degree; ++mu) {
      const int lambda = degree - nu - mu;
      Point sum{};
      if (nu > 0) sum += triangle(nu - 1, mu) * Scalar(nu);
      if (mu > 0) sum += triangle(nu, mu - 1) * Scalar(mu);
      if (lambda > 0) sum += triangle(nu, mu) * Scalar(lambda);
      result.points.push_back(sum * (Scalar(1) / Scalar(degree)));
    }
  return result;
}

}  // namespace blossom::detail
