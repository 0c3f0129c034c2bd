// SPDX-License-Identifier: LGPL-2.1-or-later
// The subdivision matrices of one direction for many pieces at once.
//
// A matrix depends on the degree and the piece alone: all rows, coordinates, cells and patches
// that are cut alike share it. Dyadic cuts come again and again, so their matrices are kept.

#pragma once

#include <span>

#include "core/forms/curve.h"
#include "core/math/interval.h"
#include "core/subdivision/bulk/bulk_storage.h"
#include "core/subdivision/bulk/simd_level.h"

namespace blossom {

/// What a net holds: control points, or the coefficients of the polynomial in x = 2t - 1, the
/// parameters with their origin in the middle (see `core/subdivision/cell_nets.h`).
enum class NetForm { Bezier, Monomial };

/// The matrices that take a net to the control points on each piece between neighbouring cuts.
///
///   Bezier:    S(k, i) = [x^i] (1 - from + from x)^(n - k) (1 - to + to x)^k
///   Monomial:  M(k, i) = [x^i] (1 + a x)^(n - k) (1 + b x)^k / binom(n, i)
///              with a = 2 from - 1, b = 2 to - 1
///
///   (1) the last row of one piece is the first of the next bit for bit
///   (2) rows of S sum to 1, and are not negative inside [0, 1]
///
/// The factors are multiplied one by one, those of `to` first, which keeps every entry accurate
/// relative to itself (S inside [0, 1]); see bulk_matrix_error.
///
/// Source: Vlachkova 2025, Theorem 1; S the same in the Bernstein basis.
class MatrixStack {
 public:
  /// degree       n, 0..kMaxDegree
  /// cuts         increasing parameters of the patch, at least 2
  /// throws       InvalidInput if the degree is out of range, a cut is not finite, there are
  ///              fewer than 2 or they do not increase
  MatrixStack(int degree, std::span<const double> cuts, NetForm form = NetForm::Bezier,
              SimdLevel level = best_simd_level());

  int degree() const { return degree_; }
  int pieces() const { return pieces_; }
  NetForm form() const { return form_; }

  double operator()(int piece, int k, int i) const {
    return rows_[static_cast<std::size_t>((piece * (degree_ + 1) + k) * (degree_ + 1) + i)];
  }

  /// All rows of all pieces, (pieces (n + 1)) x (n + 1).
  std::span<const double> rows() const { return rows_; }
  /// The transpose, (n + 1) x stride(), padded with zeros to whole lanes.
  std::span<const double> columns() const { return columns_; }
  int stride() const { return stride_; }

 private:
  int degree_;
  int pieces_;
  int stride_;
  NetForm form_;
  LaneVector rows_;
  LaneVector columns_;
};

/// Deepest level of `dyadic_matrices`: the largest stack then takes 1.4 MB.
inline constexpr int kMaxDyadicLevel = 7;

/// The stack of 2^level equal pieces of [0, 1], made once and kept until the program ends.
///
/// throws       InvalidInput if the degree or the level is out of range
///
/// Concurrent calls are safe.
const MatrixStack& dyadic_matrices(int degree, int level, NetForm form = NetForm::Bezier);

}  // namespace blossom
