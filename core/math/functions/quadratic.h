// SPDX-License-Identifier: LGPL-2.1-or-later
// A polynomial of second degree in two variables.

#pragma once

#include <algorithm>
#include <cmath>

#include "core/math/functions/polynomial.h"
#include "core/math/interval.h"

namespace blossom {

struct Quadratic {
  double constant = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;  ///< coefficients

  double at(double u, double v) const {
    return constant + u * (x + xx * u + xy * v) + v * (y + yy * v);
  }
};

/// The sum of its absolute coefficients.
inline double size(const Quadratic& f) {
  return std::abs(f.constant) + std::abs(f.x) + std::abs(f.y) + std::abs(f.xx) + std::abs(f.xy) +
         std::abs(f.yy);
}

/// The least and the largest value over a rectangle, up to rounding: at a corner, or where the
/// slope vanishes along a side or altogether.
inline PolynomialRange range(const Quadratic& f, const Interval& u, const Interval& v) {
  PolynomialRange found{f.at(u.from, v.from), f.at(u.from, v.from)};
  const auto look = [&](double s, double t) {
    const double value = f.at(s, t);
    found = {std::min(found.low, value), std::max(found.high, value)};
  };
  const auto inside = [](const Interval& range, double t) {
    return t > range.from && t < range.to;
  };
  for (const double s : {u.from, u.to}) {
    for (const double t : {v.from, v.to}) look(s, t);
    if (const double t = -(f.y + f.xy * s) / (2 * f.yy); inside(v, t)) look(s, t);
  }
  for (const double t : {v.from, v.to})
    if (const double s = -(f.x + f.xy * t) / (2 * f.xx); inside(u, s)) look(s, t);
  const double det = 4 * f.xx * f.yy - f.xy * f.xy;
  const double s = (f.xy * f.y - 2 * f.yy * f.x) / det;
  // Of a narrow valley the determinant tells little: the least value across it is at any place.
  if (const double t = -(f.y + f.xy * s) / (2 * f.yy); inside(u, s) && inside(v, t)) look(s, t);
  return found;
}

}  // namespace blossom
