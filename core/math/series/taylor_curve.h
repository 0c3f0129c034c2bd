// SPDX-License-Identifier: LGPL-2.1-or-later
// Taylor polynomials along a curve.

#pragma once

#include <array>

#include "core/math/series/taylor_series.h"

namespace blossom {

/// A polynomial along such a curve: its Bernstein coefficients on [-1, 1], the last one repeated.
struct AlongCurve {
  static constexpr std::size_t kDegree = 3 * kTaylorDegree;
  static constexpr std::size_t kPadded = kDegree + 2;  // a multiple of four

  std::array<double, kPadded> coefficients;

  /// Bounds by the coefficients.
  PolynomialRange range() const;

  /// The parts before and after t, 0 < t < 1 of the way, each on [-1, 1].
  std::array<AlongCurve, 2> parts(double t) const;
};

/// The curve (x, y)(t) for t in [-1, 1]; coefficients by rising powers of t. It keeps the powers of
/// y, which all polynomials along it share.
class TaylorCurve {
 public:
  TaylorCurve(const std::array<double, 2>& x, const std::array<double, 4>& y);

  /// p(x(t), y(t))
  AlongCurve along(const TaylorPolynomial& p) const;

 private:
  std::array<double, 2> x_;
  std::array<std::array<double, AlongCurve::kPadded>, kTaylorDegree + 1> y_powers_{};
};

}  // namespace blossom
