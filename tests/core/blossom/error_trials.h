// SPDX-License-Identifier: LGPL-2.1-or-later
// One random input on one path in double, against the same path in extended precision.

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "core/blossom/triangle_blossom.h"
#include "core/forms/patch.h"
#include "core/math/interval.h"
#include "tests/support/random.h"

namespace blossom::testing {

using Long = long double;
template <int Dim>
using LongPoint = Vec<Long, Dim>;

// The reference has the same bounds with 2^-64 for 2^-53, or is made in two such steps.
inline constexpr double kReferenceError = 0x1p-10;

template <int Dim>
LongPoint<Dim> extended(const Vec<double, Dim>& point) {
  LongPoint<Dim> result;
  for (int x = 0; x < Dim; ++x) result[x] = point[x];
  return result;
}

template <int Dim>
std::vector<LongPoint<Dim>> extended(const std::vector<Vec<double, Dim>>& points) {
  std::vector<LongPoint<Dim>> result;
  for (const auto& point : points) result.push_back(extended(point));
  return result;
}

template <int Dim>
Grid<LongPoint<Dim>> extended(const Grid<Vec<double, Dim>>& net) {
  Grid<LongPoint<Dim>> result(net.rows(), net.columns());
  for (int i = 0; i < net.rows(); ++i)
    for (int j = 0; j < net.columns(); ++j) result(i, j) = extended(net(i, j));
  return result;
}

inline IntervalOf<Long> extended(const Interval& interval) { return {interval.from, interval.to}; }

inline std::array<LongPoint<2>, 3> extended(const TriangleCorners& corners) {
  return {extended(corners[0]), extended(corners[1]), extended(corners[2])};
}

inline BezierTriangleOf<LongPoint<3>> extended(const BezierTriangle& triangle) {
  return {triangle.degree, extended(triangle.points)};
}

struct Trial {
  double error = 0;
  double bound = 0;
};

template <int Dim>
double gap(const Vec<double, Dim>& computed, const LongPoint<Dim>& expected) {
  Long largest = 0;
  for (int x = 0; x < Dim; ++x)
    largest = std::max<Long>(largest, std::abs(computed[x] - expected[x]));
  return static_cast<double>(largest);
}

template <int Dim>
double gap(std::span<const Vec<double, Dim>> computed, std::span<const LongPoint<Dim>> expected) {
  if (computed.size() != expected.size()) return std::numeric_limits<double>::infinity();
  double largest = 0;
  for (std::size_t k = 0; k < expected.size(); ++k)
    largest = std::max(largest, gap(computed[k], expected[k]));
  return largest;
}

template <int Dim>
double gap(const std::vector<Vec<double, Dim>>& computed,
           const std::vector<LongPoint<Dim>>& expected) {
  return gap<Dim>(std::span(computed), std::span(expected));
}

template <int Dim>
double gap(const Grid<Vec<double, Dim>>& computed, const Grid<LongPoint<Dim>>& expected) {
  return gap<Dim>(computed.values(), expected.values());
}

// A piece of [0, 1] of any width down to 2^-40.
inline Interval random_piece(Random& random) {
  const double width = std::ldexp(uniform(random, 0.5, 1), -pick(random, 0, 40));
  const double from = uniform(random, 0, 1 - width);
  return {from, std::min(1.0, from + width)};
}

inline Interval random_interval(Random& random) {
  return {uniform(random, -1, 2), uniform(random, -1, 2)};
}

inline TriangleCorners random_corners(Random& random) {
  TriangleCorners corners;
  const Interval u = random_piece(random), v = random_piece(random);
  for (Vec2& corner : corners)
    corner = {uniform(random, u.from, u.to), uniform(random, v.from, v.to)};
  return corners;
}

template <class Curve>
Curve centred(Curve curve, Random& random) {
  curve.centre = uniform(random, -1, 1);
  curve.scale = uniform(random, 0.25, 2);
  return curve;
}

}  // namespace blossom::testing
