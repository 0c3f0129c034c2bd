// SPDX-License-Identifier: LGPL-2.1-or-later
// Nets of cells as the engines keep them: plain arrays, halved again and again.
//
// A cell is a sub-rectangle of a patch. Its net is either the Bezier net on the cell, or the
// coefficients of the polynomial in x, y in [-1, 1], the local parameters of the cell with
// their origin in its middle ("re-centred"). Halving keeps either form.
//
// Both forms are safe at any depth, because no step enlarges an error that is already there:
// a halving of a Bezier net takes convex combinations, and a re-centred halving x = h y + m
// has |m| + h = 1, so it never enlarges the sum of the coefficients' absolute values. The
// error bounds below just count the new roundings of each step. They hold to first and second
// order, without fused operations or with them, unless numbers underflow.
//
// None of these functions allocates or checks its arguments. Output arrays must not overlap
// the input. Both directions do the same operations in the same order, so a border that two
// cells share is the same bit for bit, whichever direction it runs in.

#pragma once

#include "core/math/roundoff.h"

namespace blossom {

/// Nets of cells, coordinate planes stored one after the other (structure of arrays).
struct NetShape {
  int rows = 0;     ///< degree in u plus one, 1..kMaxDegree + 1
  int columns = 0;  ///< degree in v plus one
  int planes = 0;   ///< coordinates: 3, or 4 for homogeneous points

  /// Values in a plane; plane k starts at offset k * plane_size(), row-major inside.
  constexpr int plane_size() const { return rows * columns; }
  constexpr int size() const { return plane_size() * planes; }
  friend bool operator==(const NetShape&, const NetShape&) = default;
};

/// Halves a Bezier net of degrees up to kMaxProductDegree along u (or v) at parameter `cut`.
///
/// net       shape.size() values, model units
/// cut       in (0, 1), a fraction of the cell; at 1/2 the averages are exact up to one rounding
/// low       receives the net on [0, cut]; its last row (column) is the first of `high`
/// high      receives the net on [cut, 1]
/// accuracy  halving_error of the direction's degree, relative to the largest absolute value
/// cost      n (n + 1) / 2 affine combinations of rows, both halves together
///
/// Source: Vlachkova 2025, Theorem 1, on [0, cut] and [cut, 1]; by the triangular scheme, whose
/// intermediate values are the blossom's.
void halve_bezier_u(const NetShape& shape, const double* net, double cut, double* low,
                    double* high);
void halve_bezier_v(const NetShape& shape, const double* net, double cut, double* low,
                    double* high);

/// The same for coefficients in the cell's own x, y in [-1, 1]; those of the halves are in the
/// halves' own. With x = h y + m:
///
///   c'_k = h^k sum_{i >= k} binom(i, k) m^(i - k) c_i     h = cut,     m = cut - 1  (low)
///                                                         h = 1 - cut, m = cut      (high)
///
/// accuracy  monomial_halving_error of the direction's degree, relative to the sum of the
///           absolute values of a plane's coefficients; the same norm for the error
/// cost      at cut 1/2 n (n + 1) / 2 row operations, both halves together, else twice that
void halve_monomial_u(const NetShape& shape, const double* coefficients, double cut, double* low,
                      double* high);
void halve_monomial_v(const NetShape& shape, const double* coefficients, double cut, double* low,
                      double* high);

/// The Bezier net on the cell from its re-centred coefficients.
///
///   w_nu = sum_i c_i K(nu, i),   K(nu, i) = [x^i] (1 - x)^(n - nu) (1 + x)^nu / binom(n, i)
///
/// |K| <= 1, and K(n - nu, i) = (-1)^i K(nu, i) halves the work.
///
/// accuracy  bezier_from_monomial_error, relative to the sum of the absolute values of a
///           plane's coefficients
///
/// Source: Vlachkova 2025, Theorems 1 and 2, on [-1, 1].
void bezier_from_monomial(const NetShape& shape, const double* coefficients, double* net);

/// The re-centred coefficients from the Bezier net on the cell. Differences are taken before
/// averages, so that a smooth net keeps its high coefficients accurate:
///
///   c_i = binom(n, i) 2^-i ((1 + E) / 2)^(n - i) Delta^i p_0     (E shifts the index)
///
/// accuracy  monomial_from_bezier_error, relative to the net's largest absolute value; the
///           error's norm is the sum of absolute values of a plane's errors
/// cost      O(n^3) rows; meant for once per patch, not for once per cell
void monomial_from_bezier(const NetShape& shape, const double* net, double* coefficients);

/// Error of a Bezier net after `depth` halvings (of either direction, each of degree at most
/// `degree`), relative to the largest absolute value of the plane it started from. Each of the n
/// levels of a halving rounds 1 - cut, two products and a sum.
constexpr double halving_error(int degree, int depth) {
  return (3.0 * degree * depth + 1.0) * kUnitRoundoff;
}

/// Error of re-centred coefficients after `depth` halvings, summed over a plane, relative to the
/// sum of absolute values of the coefficients it started from. An entry of the matrix carries
/// 2n + 2 roundings, the sum of products n + 1 more.
constexpr double monomial_halving_error(int degree, int depth) {
  return (3.0 * degree + 4.0) * depth * kUnitRoundoff;
}

/// Error of a value of the net, relative to the sum of absolute values of the coefficients of
/// its plane. Each direction: K rounded once, products once, sums n times.
constexpr double bezier_from_monomial_error(int degree_u, int degree_v) {
  return (degree_u + degree_v + 5.0) * kUnitRoundoff;
}

/// Error of the coefficients of a plane, summed, relative to the largest absolute value of the
/// net. Each direction rounds n + 1 times, and sum_i binom(n, i) = 2^n is what a net can give.
constexpr double monomial_from_bezier_error(int degree_u, int degree_v) {
  double power = 1;
  for (int i = 0; i < degree_u + degree_v; ++i) power *= 2;
  return (degree_u + degree_v + 3.0) * power * kUnitRoundoff;
}

}  // namespace blossom
