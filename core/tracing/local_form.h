// SPDX-License-Identifier: LGPL-2.1-or-later
// A coordinate of a chart curve as a polynomial of the patch's own parameter.
//
// Chart curves are polynomials in the surface's parameters. In the local parameter of a patch they
// are polynomials too, unless the surface's parameter is an angle: then the local one is a tangent
// of it, and a polynomial within a proven distance has to do.

#pragma once

#include <array>
#include <span>

#include "core/forms/surface.h"

namespace blossom {

/// Highest degree of local_form.
inline constexpr int kAngleDegree = 8;

struct LocalForm {
  std::array<double, kAngleDegree + 1> coefficients{};
  int degree = 5;       ///< for a line, the wanted one for an angle
  double error = 0;     ///< bound on the distance to the true local parameter; infinite at worst
  double rounding = 0;  ///< bound on what rounding adds, in the local parameter

  /// Bezier points over [0, 1].
  std::span<const double> points() const {
    return std::span(coefficients).first(static_cast<std::size_t>(degree) + 1);
  }
};

/// The local parameter of a span along a chart coordinate.
///
///   Linear   (p - k0) / (k1 - k0), exact
///   Angle    q = (1 + tan(psi) / k) / 2 with psi = (p - (k0 + k1) / 2) / 2, k = tan((k1 - k0) /
///   4),
///            interpolated at Chebyshev's n + 1 nodes. If |q - 1/2| <= M on complex discs of radius
///            r round [-1, 1], x = 2t - 1, the error is at most M / (r^(n + 1) 2^n).
///
/// parameters   Bezier points over [0, 1] of degree 5, radians where the law is Angle
/// span         the span's knots k0 < k1
/// degree       n, for Angle: 5..kAngleDegree
/// throws       InvalidInput if the degree is out of range
///
/// Source: Cauchy's estimate of Taylor coefficients; Davis 1963, Interpolation and Approximation,
/// theorem 3.1.1.
LocalForm local_form(const std::array<double, 6>& parameters, ParameterLaw law,
                     const Interval& span, int degree);

}  // namespace blossom
