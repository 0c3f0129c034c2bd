// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/algebra/interpolation.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "core/math/binomial.h"

namespace blossom {

std::vector<double> extreme_points(int degree) {
  std::vector<double> nodes;
  for (int k = 0; k <= degree; ++k)
    nodes.push_back(0.5 - 0.5 * std::cos(k * std::numbers::pi / degree));
  nodes.back() = 1;
  return nodes;
}

template <class Point>
BezierCurveOf<Point> bezier_through(const std::vector<Point>& points) {
  const int n = static_cast<int>(points.size()) - 1;
  std::vector<Point> values = points;
  if (n < 1) return {values};
  const std::vector<double> nodes = extreme_points(n);
  Grid<double> m(n + 1, n + 1);
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const double t = nodes[static_cast<std::size_t>(i)];
      m(i, j) = binomial(n, j) * std::pow(t, j) * std::pow(1 - t, n - j);
    }
  // The matrix is totally positive: elimination without exchanges is stable.
  for (int k = 0; k <= n; ++k)
    for (int i = 0; i <= n; ++i) {
      if (i == k) continue;
      const double factor = m(i, k) / m(k, k);
      for (int j = k; j <= n; ++j) m(i, j) -= factor * m(k, j);
      values[static_cast<std::size_t>(i)] -= factor * values[static_cast<std::size_t>(k)];
    }
  for (int k = 0; k <= n; ++k) values[static_cast<std::size_t>(k)] *= 1 / m(k, k);
  return {std::move(values)};
}

template BezierCurve2 bezier_through(const std::vector<Vec2>&);
template BezierCurve bezier_through(const std::vector<Vec3>&);

Grid<Vec3> bezier_through(const Grid<Vec3>& points) {
  Grid<Vec3> net = points;
  for (int i = 0; i < net.rows(); ++i) {
    std::vector<Vec3> row;
    for (int j = 0; j < net.columns(); ++j) row.push_back(net(i, j));
    row = bezier_through(row).points;
    for (int j = 0; j < net.columns(); ++j) net(i, j) = row[static_cast<std::size_t>(j)];
  }
  for (int j = 0; j < net.columns(); ++j) {
    std::vector<Vec3> column;
    for (int i = 0; i < net.rows(); ++i) column.push_back(net(i, j));
    column = bezier_through(column).points;
    for (int i = 0; i < net.rows(); ++i) net(i, j) = column[static_cast<std::size_t>(i)];
  }
  return net;
}

double interpolation_error(double size, double length, int degree) {
  double error = size;
  for (int k = 1; k <= degree + 1; ++k) error *= 0.5 * length / k;
  return std::ldexp(error, 1 - degree);
}

}  // namespace blossom
