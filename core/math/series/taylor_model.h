// SPDX-License-Identifier: LGPL-2.1-or-later
// Functions on [-1, 1] as a polynomial and a bound on the rest, roundings included.
//
// Formulas that are templates on the scalar run on a model like on double. Where terms of two
// functions cancel, so do their polynomials: what is left is a bound on the difference, which
// interval arithmetic would not see.
//
// Source: Makino and Berz 2003, "Taylor models and other validated functional inclusion methods".

#pragma once

#include <array>
#include <cstddef>

namespace blossom {

/// f(x) = sum terms[k] x^k + r(x), |r(x)| <= rest for |x| <= 1. A rest that is infinite or no
/// number says nothing about f.
struct TaylorModel {
  static constexpr std::size_t kDegree = 15;
  /// Degree 15 is where a quarter of a circle, cut in four, is left with a rest of rounding size.
  std::array<double, kDegree + 1> terms{};
  double rest = 0;

  TaylorModel() = default;
  explicit TaylorModel(double constant) { terms[0] = constant; }

  TaylorModel& operator+=(const TaylorModel& g);
  TaylorModel& operator-=(const TaylorModel& g);
  TaylorModel& operator*=(const TaylorModel& g);
  friend TaylorModel operator+(TaylorModel f, const TaylorModel& g) { return f += g; }
  friend TaylorModel operator-(TaylorModel f, const TaylorModel& g) { return f -= g; }
  friend TaylorModel operator*(TaylorModel f, const TaylorModel& g) { return f *= g; }
  friend TaylorModel operator-(TaylorModel f);
};

/// 1 / f; its rest is infinite unless f is proven to have no root.
TaylorModel reciprocal(const TaylorModel& f);

/// The root of f; its rest is infinite unless f is proven to be positive.
TaylorModel sqrt(const TaylorModel& f);

/// Bound on |f|; infinite if there is none.
double size_bound(const TaylorModel& f);

/// Bound on |f(x) - f(0)|, f(0) taken to be terms[0]; infinite if there is none.
double change_bound(const TaylorModel& f);

}  // namespace blossom
