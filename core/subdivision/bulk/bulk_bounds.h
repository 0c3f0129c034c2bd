// SPDX-License-Identifier: LGPL-2.1-or-later
// Forward error bounds of bulk subdivision, and the choice of a path by them.
//
// Every bound counts roundings of the longest chain and multiplies by the growth of the path: the
// value the path would give with absolute values throughout. They hold to first order (the second
// is below 2^-40 of the first), with fused operations or without, unless numbers underflow.
// Relative sizes: `largest` is the largest absolute value of a plane, `sum` the sum of its
// absolute values.

#pragma once

#include <array>
#include <cmath>

#include "core/math/interval.h"
#include "core/math/roundoff.h"
#include "core/math/vec.h"
#include "core/subdivision/bulk/bulk_matrices.h"
#include "core/subdivision/growth.h"

namespace blossom {

/// Error of an entry of a MatrixStack. Bezier: relative to the entry, for cuts in [0, 1]; each of
/// the n factors rounds 1 - t, a product and a sum. Monomial: absolute, for cuts in [0, 1], where
/// no entry is above 1; each factor rounds 2t - 1 and a sum, and 1 / binom(n, i) rounds twice.
constexpr double bulk_matrix_error(int degree, NetForm form) {
  return (form == NetForm::Bezier ? 3 * degree : 2 * degree + 2) * kUnitRoundoff;
}

/// Error of a control point by matrices from a Bezier net, relative to `largest`, for pieces
/// inside the unit square. Each direction: an entry, and n + 1 roundings of its dot product.
constexpr double bulk_bezier_error(int degree_u, int degree_v) {
  return (4 * (degree_u + degree_v) + 2) * kUnitRoundoff;
}

/// Error of a control point by matrices from re-centred coefficients, relative to `sum`, for
/// pieces inside the unit square.
constexpr double bulk_monomial_error(int degree_u, int degree_v) {
  return (3 * (degree_u + degree_v) + 6) * kUnitRoundoff;
}

/// Error of a control point by the polar pyramid from re-centred coefficients, relative to `sum`
/// times pyramid_growth of u times that of v. Each direction: 1 / binom(n, i) and its product
/// round 3 times, the first pass 2n times (2 from - 1 included), powers of the width 2n times, the
/// last pass n times.
constexpr double bulk_pyramid_error(int degree_u, int degree_v) {
  return (5 * (degree_u + degree_v) + 6) * kUnitRoundoff;
}

/// |a| + |b - a| for the piece [a, b] in x = 2t - 1: at most 1 where the piece runs away from the
/// middle, and large only if a wide piece runs across it.
inline double pyramid_reach(const Interval& piece) {
  return std::abs(2 * piece.from - 1) + 2 * std::abs(piece.to - piece.from);
}

/// max(1, pyramid_reach)^n.
double pyramid_growth(int degree, const Interval& piece);

/// Error of a triangle's control point by T4 from a Bezier net, relative to `largest`, for
/// corners in the unit square. The sum over all ways to share out the points adds its terms.
constexpr double bulk_t4_error(int degree_u, int degree_v) {
  const int least = degree_u < degree_v ? degree_u : degree_v;
  const int terms = (least + 1) * (least + 2) / 2;
  return (4 * (degree_u + degree_v) + terms + 3) * kUnitRoundoff;
}

/// Likewise from re-centred coefficients, relative to `sum`.
constexpr double bulk_t4_monomial_error(int degree_u, int degree_v) {
  const int least = degree_u < degree_v ? degree_u : degree_v;
  const int terms = (least + 1) * (least + 2) / 2;
  return (3 * (degree_u + degree_v) + terms + 7) * kUnitRoundoff;
}

/// Error of a triangle's control point by T1 from re-centred coefficients, relative to `sum`
/// times t1_growth. For each of the N points: the shift rounds 2 times (2c - 1 included), alpha,
/// rho and delta carry up to 4 roundings each, their powers and passes 5, the last sums 2.
constexpr double bulk_t1_error(int degree_u, int degree_v) {
  return (16 * (degree_u + degree_v) + 8) * kUnitRoundoff;
}

/// max(1, X_1)^n max(1, X_2)^m, where X_p bounds parameter p (in x = 2t - 1) over the paths that T1
/// takes: from the origin to c, then along the sides A = a - c and B = b - c, B by way of A.
double t1_growth(int degree_u, int degree_v, const std::array<Vec2, 3>& corners);

enum class PiecePath { BezierMatrices, MonomialPyramid };
enum class TrianglePath { BezierT4, MonomialT1 };

/// Sizes of the two forms of one net, the largest over its planes.
struct NetSizes {
  double largest = 0;     ///< of the control points
  double sum = 0;         ///< of the coefficients of a plane
  double conversion = 0;  ///< error of the coefficients, summed over a plane; model units
};

/// The cheapest path that keeps a piece within the tolerance (model units); BezierMatrices, the
/// most accurate, where none does.
PiecePath piece_path(int degree_u, int degree_v, const NetSizes& sizes, const Interval& u,
                     const Interval& v, double tolerance);
TrianglePath triangle_path(int degree_u, int degree_v, const NetSizes& sizes,
                           const std::array<Vec2, 3>& corners, double tolerance);

/// The same for all pieces whose pyramid_reach is at most these.
PiecePath piece_path(int degree_u, int degree_v, const NetSizes& sizes, double reach_u,
                     double reach_v, double tolerance);

/// The error bound of a path for a piece or a triangle, model units.
double piece_error(PiecePath path, int degree_u, int degree_v, const NetSizes& sizes,
                   const Interval& u, const Interval& v);
double triangle_error(TrianglePath path, int degree_u, int degree_v, const NetSizes& sizes,
                      const std::array<Vec2, 3>& corners);

}  // namespace blossom
