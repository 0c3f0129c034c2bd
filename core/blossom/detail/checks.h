// SPDX-License-Identifier: LGPL-2.1-or-later
// What the functions on blossoms share: preconditions, local parameters, absolute values.

#pragma once

#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "core/base/errors.h"
#include "core/forms/triangle.h"
#include "core/math/detail/scalar.h"
#include "core/math/interval.h"
#include "core/math/vec.h"

namespace blossom::detail {

/// Throws InvalidInput unless there are `degree` finite parameters.
/// what     what has the degree: "curve", "patch along u"
inline void check_parameters(const char* function, const char* what, int degree,
                             std::span<const double> parameters) {
  if (static_cast<int>(parameters.size()) != degree)
    throw InvalidInput(std::string(function) + ": a " + what + " of degree " +
                       std::to_string(degree) + " takes " + std::to_string(degree) +
                       " parameters, got " + std::to_string(parameters.size()));
  for (std::size_t k = 0; k < parameters.size(); ++k)
    if (!std::isfinite(parameters[k]))
      throw InvalidInput(std::string(function) + ": parameter " + std::to_string(k + 1) + " of a " +
                         what + " is not finite");
}

/// (t - centre) / scale for each parameter.
inline std::vector<double> local_parameters(std::span<const double> parameters, double centre,
                                            double scale) {
  std::vector<double> local;
  for (const double t : parameters) local.push_back((t - centre) / scale);
  return local;
}

/// The blossom of a Bezier curve: one affine step for each parameter.
template <class Point>
Point casteljau_blossom(std::vector<Point> points, std::span<const double> parameters) {
  for (const double t : parameters) {
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
      points[k] = points[k] * (1 - t) + points[k + 1] * t;
    points.pop_back();
  }
  return points[0];
}

/// The blossom of a triangle with one argument given: a triangle of one degree less.
template <class Point>
BezierTriangleOf<Point> blossom_step(const BezierTriangleOf<Point>& triangle,
                                     const Vec<scalar_of<Point>, 2>& argument) {
  using Scalar = scalar_of<Point>;
  const Scalar rest = Scalar(1) - argument[0] - argument[1];
  BezierTriangleOf<Point> result{triangle.degree - 1, {}};
  for (int nu = 0; nu <= result.degree; ++nu)
    for (int mu = 0; nu + mu <= result.degree; ++mu)
      result.points.push_back(triangle(nu + 1, mu) * argument[0] +
                              triangle(nu, mu + 1) * argument[1] + triangle(nu, mu) * rest);
  return result;
}

template <int Dim>
Vec<double, Dim> absolute(Vec<double, Dim> point) {
  for (int i = 0; i < Dim; ++i) point[i] = std::abs(point[i]);
  return point;
}

inline Interval absolute(const Interval& interval) {
  return {std::abs(interval.from), std::abs(interval.to)};
}

}  // namespace blossom::detail
