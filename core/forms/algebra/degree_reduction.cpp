// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/algebra/detail/degree_reduction.h"

#include <cmath>
#include <utility>
#include <vector>

#include "core/forms/algebra/detail/products.h"
#include "core/math/matrix.h"

namespace blossom::detail {
namespace {

// Column i: B_i of degree `lower` in Bernstein form of degree `degree`.
Grid<double> elevation_matrix(int degree, int lower) {
  Grid<double> identity(lower + 1, lower + 1, 0.0);
  for (int i = 0; i <= lower; ++i) identity(i, i) = 1;
  return elevated_net(identity, degree - lower, 0);
}

// (1 + factor normal normal^T) on the columns from `first` on of the rows from k on, row by row.
void apply(const std::vector<double>& normal, double factor, int k, int first,
           Grid<double>& matrix) {
  std::vector<double> sums(index(matrix.columns()), 0.0);
  for (int i = k; i < matrix.rows(); ++i)
    for (int j = first; j < matrix.columns(); ++j)
      sums[index(j)] += normal[index(i - k)] * matrix(i, j);
  for (double& sum : sums) sum *= factor;
  for (int i = k; i < matrix.rows(); ++i)
    for (int j = first; j < matrix.columns(); ++j)
      matrix(i, j) += sums[index(j)] * normal[index(i - k)];
}

// One reflection of Householder: makes column k of `a` zero below its diagonal, and does the same
// to all columns of `b`.
void reflect(Grid<double>& a, Grid<double>& b, int k) {
  double square = 0;
  for (int i = k; i < a.rows(); ++i) square += a(i, k) * a(i, k);
  const double length = a(k, k) > 0 ? -std::sqrt(square) : std::sqrt(square);
  if (length == 0) return;
  std::vector<double> normal;
  for (int i = k; i < a.rows(); ++i) normal.push_back(a(i, k));
  normal[0] -= length;
  const double factor = 1 / (length * normal[0]);
  apply(normal, factor, k, k, a);
  apply(normal, factor, k, 0, b);
}

// The x that makes |a x - b| least, for each column of b; a has full rank.
// Source: Golub and Van Loan 2013, 5.3.
Grid<double> least_squares(Grid<double> a, Grid<double> b) {
  for (int k = 0; k < a.columns(); ++k) reflect(a, b, k);
  Grid<double> x(a.columns(), b.columns());
  for (int i = a.columns() - 1; i >= 0; --i) {
    for (int j = 0; j < b.columns(); ++j) x(i, j) = b(i, j);
    for (int k = i + 1; k < a.columns(); ++k)
      for (int j = 0; j < b.columns(); ++j) x(i, j) -= a(i, k) * x(k, j);
    for (int j = 0; j < b.columns(); ++j) x(i, j) /= a(i, i);
  }
  return x;
}

Grid<double> identity_matrix(int size) {
  Grid<double> matrix(size, size, 0.0);
  for (int i = 0; i < size; ++i) matrix(i, i) = 1;
  return matrix;
}

// Fills the rows of `result` that are not given such that elevation * result is nearest to the
// identity. Given rows go to the right-hand side.
void complete(const Grid<double>& elevation, const std::vector<bool>& given, Grid<double>& result) {
  std::vector<int> open;
  for (int i = 0; i < result.rows(); ++i)
    if (!given[index(i)]) open.push_back(i);
  if (open.empty()) return;
  Grid<double> inner(elevation.rows(), static_cast<int>(open.size()));
  for (int k = 0; k < inner.rows(); ++k)
    for (int i = 0; i < inner.columns(); ++i) inner(k, i) = elevation(k, open[index(i)]);
  Grid<double> wanted = product(elevation, result);
  for (double& value : wanted.values()) value = -value;
  for (int k = 0; k < wanted.rows(); ++k) wanted(k, k) += 1;
  const Grid<double> found = least_squares(std::move(inner), std::move(wanted));
  for (int i = 0; i < found.rows(); ++i)
    for (int k = 0; k < found.columns(); ++k) result(open[index(i)], k) = found(i, k);
}

using Triangle = BezierTriangleOf<double>;

// Column i: the i-th Bernstein polynomial of degree `lower`, elevated.
Grid<double> triangle_elevation_matrix(int degree, int lower) {
  const std::size_t count = Triangle::count(lower);
  Grid<double> matrix(static_cast<int>(Triangle::count(degree)), static_cast<int>(count));
  for (int i = 0; i < matrix.columns(); ++i) {
    Triangle unit{lower, std::vector<double>(count, 0.0)};
    unit.points[index(i)] = 1;
    while (unit.degree < degree) unit = elevated_once(unit);
    for (int k = 0; k < matrix.rows(); ++k) matrix(k, i) = unit.points[index(k)];
  }
  return matrix;
}

// Places of the points of a side: 0 from c to b, 1 from c to a, 2 from b to a.
std::vector<int> side_of(int degree, int side) {
  std::vector<int> places;
  for (int k = 0; k <= degree; ++k) {
    const int nu = side == 0 ? 0 : k;
    const int mu = side == 0 ? k : side == 1 ? 0 : degree - k;
    places.push_back(static_cast<int>(Triangle::index(degree, nu, mu)));
  }
  return places;
}

}  // namespace

Grid<double> reduction_matrix(int degree, int lower) {
  if (lower == degree) return identity_matrix(degree + 1);
  Grid<double> result(lower + 1, degree + 1, 0.0);
  std::vector<bool> given(index(lower + 1), false);
  if (lower > 0) {
    given.front() = given.back() = true;
    result(0, 0) = result(lower, degree) = 1;
  }
  complete(elevation_matrix(degree, lower), given, result);
  return result;
}

Grid<double> triangle_reduction_matrix(int degree, int lower) {
  const int rows = static_cast<int>(Triangle::count(lower)),
            columns = static_cast<int>(Triangle::count(degree));
  if (lower == degree) return identity_matrix(columns);
  Grid<double> result(rows, columns, 0.0);
  std::vector<bool> given(index(rows), false);
  const Grid<double> of_side = reduction_matrix(degree, lower);
  for (int side = 0; side < 3 && lower > 0; ++side) {
    const std::vector<int> to = side_of(lower, side), from = side_of(degree, side);
    for (int i = 0; i <= lower; ++i) {
      given[index(to[index(i)])] = true;
      for (int k = 0; k <= degree; ++k) result(to[index(i)], from[index(k)]) = of_side(i, k);
    }
  }
  complete(triangle_elevation_matrix(degree, lower), given, result);
  return result;
}

}  // namespace blossom::detail
