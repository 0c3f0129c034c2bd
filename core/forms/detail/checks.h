// SPDX-License-Identifier: LGPL-2.1-or-later
// Preconditions of the functions on forms, with one wording.

#pragma once

#include <cmath>
#include <sstream>
#include <string>

#include "core/base/errors.h"
#include "core/forms/curve.h"
#include "core/forms/triangle.h"
#include "core/math/interval.h"

namespace blossom::detail {

/// A number in a message: short, and with an exponent where it needs one.
inline std::string text(double value) {
  std::ostringstream stream;
  stream << value;
  return stream.str();
}

/// Throws InvalidInput unless 0 <= degree <= highest.
inline void check_degree(const char* function, int degree, int highest = kMaxDegree) {
  if (degree >= 0 && degree <= highest) return;
  throw InvalidInput(std::string(function) + ": the degree must be 0.." + std::to_string(highest) +
                     ", got " + std::to_string(degree));
}

/// Throws InvalidInput unless 0 <= degree <= highest and the number of points fits the degree.
template <class Point>
void check_triangle(const char* function, const BezierTriangleOf<Point>& triangle, int highest) {
  check_degree(function, triangle.degree, highest);
  const std::size_t wanted = BezierTriangleOf<Point>::count(triangle.degree);
  if (triangle.points.size() == wanted) return;
  throw InvalidInput(std::string(function) + ": a triangle of degree " +
                     std::to_string(triangle.degree) + " has " + std::to_string(wanted) +
                     " points, got " + std::to_string(triangle.points.size()));
}

/// Throws InvalidInput unless both ends are finite.
inline void check_interval(const char* function, const char* name, const Interval& interval) {
  if (std::isfinite(interval.from) && std::isfinite(interval.to)) return;
  throw InvalidInput(std::string(function) + ": the interval " + name + " must be finite, got [" +
                     text(interval.from) + ", " + text(interval.to) + "]");
}

/// Throws InvalidInput unless the centre is finite and the scale finite and not 0.
inline void check_placement(const char* function, double centre, double scale) {
  if (std::isfinite(centre) && std::isfinite(scale) && scale != 0) return;
  throw InvalidInput(std::string(function) +
                     ": the centre must be finite and the scale finite and not 0, got " +
                     text(centre) + " and " + text(scale));
}

}  // namespace blossom::detail
