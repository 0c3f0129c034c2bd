// SPDX-License-Identifier: LGPL-2.1-or-later
// The matrices of subdivision: one direction, one degree, one piece.
//
// The points of a piece of a curve are S p, those of a sub-patch S_u P S_v^T. A matrix depends on
// the degree and the piece alone, so all curves, rows and coordinates share it.

#pragma once

#include "core/forms/curve.h"
#include "core/math/grid.h"
#include "core/math/interval.h"
#include "core/math/roundoff.h"

namespace blossom {

/// The matrix that takes the Bezier points of a curve to those of its piece.
///
///   S(k, i) = sum_r B_r^k(to) B_(i - r)^(n - k)(from)
///           = the blossom of the Bernstein polynomial B_i at n - k copies of `from` and k of `to`
///
///   (1) every row sums to 1
///   (2) inside [0, 1] no entry is negative, so pieces stay in the convex hull
///   (3) the last row of one piece and the first row of the next are the same bit for bit
///
/// degree       n, 0..kMaxDegree
/// piece        parameters of the piece; from > to reverses it
/// returns      (n + 1) x (n + 1)
/// throws       InvalidInput if n is out of range or an end is not finite
/// cost         O(n^3)
///
/// Source: Vlachkova 2025, Theorem 1, in the Bernstein basis.
Grid<double> subdivision_matrix(int degree, const Interval& piece);

/// The matrix that takes plain monomial coefficients to the Bezier points of a piece.
///
///   M(k, i) = 1 / binom(n, i) sum_r binom(k, r) binom(n - k, i - r) to^r from^(i - r)
///
/// degree, piece, returns, throws, cost   as above
///
/// Source: Vlachkova 2025, Theorem 1.
Grid<double> monomial_matrix(int degree, const Interval& piece);

/// Bound on the error of a coordinate of a piece of a curve inside [0, 1], relative to the
/// largest coordinate. An entry of S is a sum of at most n / 2 + 1 products of Bernstein
/// polynomials, which carry 3n roundings together; a dot product has n + 1 more.
constexpr double curve_subdivision_error(int degree) { return (4.5 * degree + 4) * kUnitRoundoff; }

/// The same for a sub-patch inside the unit square: two directions of at most this degree.
constexpr double subdivision_error(int degree) { return 2 * curve_subdivision_error(degree); }

}  // namespace blossom
