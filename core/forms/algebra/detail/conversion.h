// SPDX-License-Identifier: LGPL-2.1-or-later
// The formulas of conversion over any scalar, for one line of points.

#pragma once

#include <vector>

#include "core/forms/algebra/conversion.h"
#include "core/math/detail/bernstein.h"
#include "core/math/matrix.h"

namespace blossom::detail {

/// Delta^0 p_0, Delta^1 p_0, ..: forward differences at the first point.
template <class Point>
std::vector<Point> differences_at_start(std::vector<Point> row) {
  std::vector<Point> result;
  while (!row.empty()) {
    result.push_back(row.front());
    for (std::size_t k = 0; k + 1 < row.size(); ++k) row[k] = row[k + 1] - row[k];
    row.pop_back();
  }
  return result;
}

/// ((1 + E) / 2)^(n - i) Delta^i p_0 for i = 0..n.
template <class Point>
std::vector<Point> differences_in_middle(std::vector<Point> row) {
  using Scalar = typename Point::scalar_type;
  const Scalar half(0.5);
  std::vector<Point> result;
  while (!row.empty()) {
    std::vector<Point> averages = row;
    for (; averages.size() > 1; averages.pop_back())
      for (std::size_t k = 0; k + 1 < averages.size(); ++k)
        averages[k] = (averages[k] + averages[k + 1]) * half;
    result.push_back(averages.front());
    for (std::size_t k = 0; k + 1 < row.size(); ++k) row[k] = row[k + 1] - row[k];
    row.pop_back();
  }
  return result;
}

/// Monomial coefficients from Bezier points.
template <class Point>
std::vector<Point> monomial_line(const std::vector<Point>& points, Origin origin) {
  using Scalar = typename Point::scalar_type;
  const bool middle = origin == Origin::Middle;
  std::vector<Point> line = middle ? differences_in_middle(points) : differences_at_start(points);
  const int n = static_cast<int>(points.size()) - 1;
  double power = 1;
  for (int i = 0; i <= n; ++i, power *= middle ? 0.5 : 1)
    line[index(i)] *= Scalar(binomial(n, i) * power);
  return line;
}

/// The same along the columns, then along the rows of a net.
template <class Point>
Grid<Point> monomial_net(const Grid<Point>& net, Origin origin) {
  Grid<Point> result = net;
  std::vector<Point> line(index(net.rows()));
  for (int j = 0; j < net.columns(); ++j) {
    for (int i = 0; i < net.rows(); ++i) line[index(i)] = net(i, j);
    const std::vector<Point> converted = monomial_line(line, origin);
    for (int i = 0; i < net.rows(); ++i) result(i, j) = converted[index(i)];
  }
  line.resize(index(net.columns()));
  for (int i = 0; i < net.rows(); ++i) {
    for (int j = 0; j < net.columns(); ++j) line[index(j)] = result(i, j);
    const std::vector<Point> converted = monomial_line(line, origin);
    for (int j = 0; j < net.columns(); ++j) result(i, j) = converted[index(j)];
  }
  return result;
}

/// c_ij of a Bezier triangle in its barycentric x and y.
template <class Point>
Grid<Point> monomial_triangle(const BezierTriangleOf<Point>& triangle) {
  using Scalar = typename Point::scalar_type;
  const int n = triangle.degree;
  Grid<Point> result(n + 1, n + 1);
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) result(i, j) = triangle(i, j);
  // After step k the entries with i >= k hold k differences towards a; then the same towards b.
  for (int k = 1; k <= n; ++k)
    for (int i = n; i >= k; --i)
      for (int j = 0; i + j <= n; ++j) result(i, j) -= result(i - 1, j);
  for (int k = 1; k <= n; ++k)
    for (int j = n; j >= k; --j)
      for (int i = 0; i + j <= n; ++i) result(i, j) -= result(i, j - 1);
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) result(i, j) *= Scalar(trinomial(n, i, j));
  return result;
}

/// An interval of the parameter in the local parameter (t - centre) / scale.
template <class Scalar>
IntervalOf<Scalar> local_interval(const IntervalOf<Scalar>& interval, double centre, double scale) {
  const Scalar origin(centre), unit(scale);
  return {(interval.from - origin) / unit, (interval.to - origin) / unit};
}

/// The Bezier points on an interval from coefficients with a centre and a scale.
template <class Point>
std::vector<Point> bezier_line(const MonomialCurveOf<Point>& curve,
                               const IntervalOf<typename Point::scalar_type>& interval) {
  return product(
      monomial_matrix(curve.degree(), local_interval(interval, curve.centre, curve.scale)),
      curve.coefficients);
}

/// The Bezier net on u x v from coefficients with centres and scales.
template <class Point>
Grid<Point> bezier_net(const MonomialPatchOf<Point>& patch,
                       const IntervalOf<typename Point::scalar_type>& u,
                       const IntervalOf<typename Point::scalar_type>& v) {
  const auto along_u =
      monomial_matrix(patch.degree_u(), local_interval(u, patch.centre_u, patch.scale_u));
  const auto along_v =
      monomial_matrix(patch.degree_v(), local_interval(v, patch.centre_v, patch.scale_v));
  return product_transposed(product(along_u, patch.coefficients), along_v);
}

}  // namespace blossom::detail
