// SPDX-License-Identifier: LGPL-2.1-or-later
// Exact evaluation of Bezier forms at rational parameters, slow and obvious.

#pragma once

#include <vector>

#include "core/forms/triangle.h"
#include "tests/support/exact.h"

namespace blossom::testing {

/// de Casteljau's algorithm.
template <class Point>
Point exact_point(std::vector<Point> points, const Rational& t) {
  const Rational rest = 1 - t;
  for (; points.size() > 1; points.pop_back())
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
      points[k] = points[k] * rest + points[k + 1] * t;
  return points[0];
}

template <class Point>
Point exact_point(const Grid<Point>& net, const Rational& u, const Rational& v) {
  std::vector<Point> column;
  for (int i = 0; i < net.rows(); ++i) {
    std::vector<Point> row;
    for (int j = 0; j < net.columns(); ++j) row.push_back(net(i, j));
    column.push_back(exact_point(row, v));
  }
  return exact_point(column, u);
}

template <class Point>
Point exact_point(const BezierTriangleOf<Point>& triangle, const Rational& x, const Rational& y) {
  const Rational z = 1 - x - y;
  BezierTriangleOf<Point> level = triangle;
  while (level.degree > 0) {
    BezierTriangleOf<Point> next{level.degree - 1, {}};
    for (int nu = 0; nu <= next.degree; ++nu)
      for (int mu = 0; nu + mu <= next.degree; ++mu)
        next.points.push_back(level(nu + 1, mu) * x + level(nu, mu + 1) * y + level(nu, mu) * z);
    level = next;
  }
  return level.points[0];
}

template <int Dim>
BezierTriangleOf<Vec<Rational, Dim>> exact(const BezierTriangleOf<Vec<double, Dim>>& triangle) {
  return {triangle.degree, exact(triangle.points)};
}

inline std::vector<Rational> exact(const std::vector<double>& values) {
  return {values.begin(), values.end()};
}

inline Grid<Rational> exact(const Grid<double>& values) {
  Grid<Rational> result(values.rows(), values.columns());
  for (int i = 0; i < values.rows(); ++i)
    for (int j = 0; j < values.columns(); ++j) result(i, j) = Rational(values(i, j));
  return result;
}

}  // namespace blossom::testing
