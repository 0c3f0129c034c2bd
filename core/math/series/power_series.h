// SPDX-License-Identifier: LGPL-2.1-or-later
// Functions on [-1, 1] as a polynomial of low degree and a bound on the rest.

#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "core/math/vec.h"

namespace blossom {

inline constexpr std::size_t kSeriesDegree = 15;

/// sum terms[k] x^k for |x| <= 1.
template <class Point>
struct PowerSeries {
  std::array<Point, kSeriesDegree + 1> terms{};
  Point rest{};  ///< bound on each coordinate of what is left out
};

inline double absolute(double x) { return std::abs(x); }

/// The sum of the terms' absolute values, by coordinates: a bound on the polynomial.
template <class Point>
Point absolute_sum(const PowerSeries<Point>& f) {
  Point sum{};
  for (const Point& term : f.terms) sum += absolute(term);
  return sum;
}

/// f g. Terms of g above `degree` are zero.
template <class Point>
PowerSeries<Point> product(const PowerSeries<double>& f, const PowerSeries<Point>& g,
                           std::size_t degree = kSeriesDegree) {
  PowerSeries<Point> result;
  for (std::size_t q = 0; q <= degree; ++q) {
    for (std::size_t p = 0; p + q <= kSeriesDegree; ++p)
      result.terms[p + q] += f.terms[p] * g.terms[q];
    double cut = f.rest;
    for (std::size_t p = kSeriesDegree + 1 - q; p <= kSeriesDegree; ++p)
      cut += std::abs(f.terms[p]);
    result.rest += cut * absolute(g.terms[q]);
  }
  result.rest += (absolute_sum(f) + f.rest) * g.rest;
  return result;
}

/// The first terms of 1 / f, without a rest: product(f, reciprocal(f)) tells how far it is from 1.
/// f(0) is not zero.
inline PowerSeries<double> reciprocal(const PowerSeries<double>& f) {
  PowerSeries<double> result;
  result.terms[0] = 1 / f.terms[0];
  for (std::size_t k = 1; k <= kSeriesDegree; ++k) {
    double sum = 0;
    for (std::size_t p = 1; p <= k; ++p) sum += f.terms[p] * result.terms[k - p];
    result.terms[k] = -sum * result.terms[0];
  }
  return result;
}

}  // namespace blossom
