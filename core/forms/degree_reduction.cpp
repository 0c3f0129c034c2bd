// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/detail/degree_reduction.h"

#include <cmath>

#include "core/forms/detail/products.h"

namespace blossom::detail {
namespace {

// Column i: B_i of degree `lower` in Bernstein form of degree `degree`.
Grid<double> elevation_matrix(int degree, int lower) {
  Grid<double> identity(lower + 1, lower + 1, 0.0);
  for (int i = 0; i <= lower; ++i) identity(i, i) = 1;
  return elevated_net(identity, degree - lower, 0);
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
  const auto apply = [&](Grid<double>& matrix, int column) {
    double sum = 0;
    for (int i = k; i < matrix.rows(); ++i) sum += normal[index(i - k)] * matrix(i, column);
    for (int i = k; i < matrix.rows(); ++i)
      matrix(i, column) += factor * sum * normal[index(i - k)];
  };
  for (int j = k; j < a.columns(); ++j) apply(a, j);
  for (int j = 0; j < b.columns(); ++j) apply(b, j);
}

// The x that makes |a x - b| least, for each column of b; a has full rank.
// Source: Golub and Van Loan 2013, 5.3.
Grid<double> least_squares(Grid<double> a, Grid<double> b) {
  for (int k = 0; k < a.columns(); ++k) reflect(a, b, k);
  Grid<double> x(a.columns(), b.columns());
  for (int j = 0; j < b.columns(); ++j)
    for (int i = a.columns() - 1; i >= 0; --i) {
      double rest = b(i, j);
      for (int k = i + 1; k < a.columns(); ++k) rest -= a(i, k) * x(k, j);
      x(i, j) = rest / a(i, i);
    }
  return x;
}

Grid<double> identity_matrix(int size) {
  Grid<double> matrix(size, size, 0.0);
  for (int i = 0; i < size; ++i) matrix(i, i) = 1;
  return matrix;
}

}  // namespace

Grid<double> reduction_matrix(int degree, int lower) {
  const Grid<double> elevation = elevation_matrix(degree, lower);
  Grid<double> wanted = identity_matrix(degree + 1);
  if (lower == degree) return wanted;
  if (lower == 0) return least_squares(elevation, wanted);
  // The ends are given: they go to the right-hand side.
  Grid<double> result(lower + 1, degree + 1, 0.0);
  result(0, 0) = result(lower, degree) = 1;
  if (lower == 1) return result;
  Grid<double> inner(degree + 1, lower - 1);
  for (int k = 0; k <= degree; ++k) {
    wanted(k, 0) -= elevation(k, 0);
    wanted(k, degree) -= elevation(k, lower);
    for (int i = 1; i < lower; ++i) inner(k, i - 1) = elevation(k, i);
  }
  const Grid<double> found = least_squares(inner, wanted);
  for (int i = 1; i < lower; ++i)
    for (int k = 0; k <= degree; ++k) result(i, k) = found(i - 1, k);
  return result;
}

}  // namespace blossom::detail
