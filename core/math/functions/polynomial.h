// SPDX-License-Identifier: LGPL-2.1-or-later
// Polynomials of one variable on [-1, 1]: range and isolated roots.

#pragma once

#include <array>
#include <optional>
#include <vector>

namespace blossom {

inline constexpr int kPolynomialDegree = 6;

/// sum c_i t^i.
using Polynomial = std::array<double, kPolynomialDegree + 1>;

double value(const Polynomial& p, double t);

/// Value and derivative.
struct PolynomialJet {
  double value;
  double slope;
};
PolynomialJet jet_at(const Polynomial& p, double t);

/// Bounds on [-1, 1] by Bernstein coefficients.
struct PolynomialRange {
  double low;
  double high;
};
PolynomialRange range(const Polynomial& p);

/// A sign change of a function that is known as a polynomial within an error.
struct IsolatedRoot {
  double t;
  bool rising;
};

/// All roots in [from, to], within [-1, 1], of every function f with |f - p| <= error and
/// |f' - p'| <= slope_error.
///
/// returns   in order; each is simple, and there are no others. Nothing if the errors or a
///           multiple root leave the number undecided
std::optional<std::vector<IsolatedRoot>> isolated_roots(const Polynomial& p, double error,
                                                        double slope_error, double from, double to);

}  // namespace blossom
