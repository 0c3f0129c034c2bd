// SPDX-License-Identifier: LGPL-2.1-or-later
// What a pair of cells proves about the intersection inside it.
//
// The four unknowns are x = (u, v) on the cell of a and (s, t) on the cell of b, each in the
// cell's own [0, 1]; F(x) = A(u, v) - B(s, t). J is its 3 x 4 Jacobian over the whole pair.

#pragma once

#include <array>

#include "core/cells/cell_tree.h"

namespace blossom {

/// True if boxes or fat planes prove that the cells are farther apart than `gap`, rounding
/// included.
bool separated(const Cell& a, const Cell& b, int points_a, int points_b, double gap = 0);

/// True if the cells are because their heights over some plane with this normal are.
bool separated_along(const Vec3& normal, const Cell& a, const Cell& b, int points_a, int points_b,
                     double gap = 0);

/// True if the cells are as two flat parallelograms would be that are apart across the line of
/// their planes: one of the four directions square to an edge of either proves it.
/// Source: Gottschalk, Lin, Manocha 1996 (separating axes).
bool separated_across(const Cell& a, const Cell& b, int points_a, int points_b, double gap = 0);

/// True if all of both cells lies within a slab of the given thickness: the surfaces stay
/// within that distance of each other, seen along the slab's normal.
bool within_slab(const Cell& a, const Cell& b, int points_a, int points_b, double thickness);

/// True if both cells are nearly flat and some of their normals may be parallel.
bool nearly_parallel(const Cell& a, const Cell& b);

/// Whether the first of two cells bends no less; size counts a little.
bool is_halved_first(const Cell& a, const Cell& b);

using Matrix3 = std::array<std::array<double, 3>, 3>;

/// The minor of J that leaves one column out, over a pair of cells.
struct Minor {
  bool regular = false;  ///< every matrix within the bounds is regular
  Matrix3 inverse{};     ///< C, the inverse of the middle matrix
  Matrix3 spread{};      ///< E >= |I - C J| for all J within the bounds; its spectral radius < 1
};

/// The bounds of the four columns of J over a pair of cells.
class JacobianBounds {
 public:
  JacobianBounds(const Cell& a, const Cell& b);

  /// Of the four columns themselves.
  explicit JacobianBounds(const std::array<VectorBounds, 4>& columns) : columns_(columns) {}

  /// Of a curve with this derivative, in place of a, and a cell. Column 1 is 0, so `minor(1)` is
  /// the only one to ask for.
  JacobianBounds(const VectorBounds& curve, const Cell& b);

  /// If `minor(k)` is regular, F = 0 has at most one solution for each value of x_k: the
  /// solutions are arcs that run from border to border, with no loop and no branching.
  ///
  /// Regular is proven by |C| rad(J) having spectral radius below 1, which a positive vector x
  /// with |C| rad(J) x < x shows (Collatz and Wielandt).
  Minor minor(int left_out) const;

  const VectorBounds& column(int k) const { return columns_[static_cast<std::size_t>(k)]; }

  /// The column whose minor has the largest determinant in the middle, for unit columns.
  int best_column() const;

  /// The best of the columns whose minors are regular; -1 if there is none, or arcs move so slowly
  /// along its parameter, beside the fastest one, that they may run along its borders.
  int certified_column() const;

 private:
  std::array<VectorBounds, 4> columns_;
};

/// The three columns that a minor keeps, in order.
inline std::array<int, 3> kept_columns(int left_out) {
  return {left_out > 0 ? 0 : 1, left_out > 1 ? 1 : 2, left_out > 2 ? 2 : 3};
}

}  // namespace blossom
