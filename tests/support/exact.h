// SPDX-License-Identifier: LGPL-2.1-or-later
// Exact rational numbers for tests, and the way to them from doubles.

#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <vector>

#include "core/math/grid.h"
#include "core/math/vec.h"

namespace blossom::testing {

using Rational = boost::multiprecision::cpp_rational;

template <int Dim>
Vec<Rational, Dim> exact(const Vec<double, Dim>& point) {
  Vec<Rational, Dim> result;
  for (int i = 0; i < Dim; ++i) result[i] = Rational(point[i]);
  return result;
}

template <int Dim>
std::vector<Vec<Rational, Dim>> exact(const std::vector<Vec<double, Dim>>& points) {
  std::vector<Vec<Rational, Dim>> result;
  for (const auto& point : points) result.push_back(exact(point));
  return result;
}

template <int Dim>
Grid<Vec<Rational, Dim>> exact(const Grid<Vec<double, Dim>>& net) {
  Grid<Vec<Rational, Dim>> result(net.rows(), net.columns());
  for (int i = 0; i < net.rows(); ++i)
    for (int j = 0; j < net.columns(); ++j) result(i, j) = exact(net(i, j));
  return result;
}

/// Correctly rounded.
template <int Dim>
Vec<double, Dim> rounded(const Vec<Rational, Dim>& point) {
  Vec<double, Dim> result;
  for (int i = 0; i < Dim; ++i) result[i] = point[i].template convert_to<double>();
  return result;
}

/// |computed - expected|, with the difference taken exactly.
inline double exact_gap(double computed, const Rational& expected) {
  const Rational gap = Rational(computed) - expected;
  return abs(gap).convert_to<double>();
}

template <int Dim>
double exact_gap(const Vec<double, Dim>& computed, const Vec<Rational, Dim>& expected) {
  double largest = 0;
  for (int i = 0; i < Dim; ++i) largest = std::max(largest, exact_gap(computed[i], expected[i]));
  return largest;
}

}  // namespace blossom::testing
