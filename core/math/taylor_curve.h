// SPDX-License-Identifier: LGPL-2.1-or-later
// Taylor polynomials along a curve.

#pragma once

#include <array>

#include "core/math/taylor_series.h"

namespace blossom {

/// The curve (x, y)(t) for t in [-1, 1]; coefficients by rising powers of t. It keeps the powers of
/// y, which all polynomials along it share.
class TaylorCurve {
 public:
  TaylorCurve(const std::array<double, 2>& x, const std::array<double, 4>& y);

  /// Bounds of p(x(t), y(t)) by its Bernstein coefficients on [-1, 1].
  PolynomialRange range(const TaylorPolynomial& p) const;

 private:
  static constexpr std::size_t kDegree = 3 * kTaylorDegree;
  static constexpr std::size_t kPadded = kDegree + 2;  // a multiple of four

  std::array<double, 2> x_;
  std::array<std::array<double, kPadded>, kTaylorDegree + 1> y_powers_{};
};

}  // namespace blossom
