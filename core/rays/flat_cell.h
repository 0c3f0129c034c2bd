// SPDX-License-Identifier: LGPL-2.1-or-later
// A cell of a patch with what makes queries on it fast, if it is nearly flat.
//
// In the cell's own parameters x in [-1/2, 1/2]^2, S(x) = S(0) + x_u M_u + x_v M_v + rest. The dual
// vectors D (D_i . M_j = 1 or 0) and the unit normal N turn the rest into numbers: for every
// derivative S_j of the cell
//
//   |D_i . (S_j - M_j)| <= spread[i][j],   |N . (S_j - M_j)| <= tilt[j]
//
// so where and how often a line or a foot point can be in the cell follows from these six numbers.

#pragma once

#include <array>

#include "core/forms/patch.h"
#include "core/math/interval.h"
#include "core/math/vec.h"
#include "core/rays/two_forms.h"

namespace blossom {

struct Cell;

struct FlatCell {
  int patch = 0;         ///< index into FlatCells::patches()
  bool regular = false;  ///< false near poles: then there are no dual vectors
  Interval u, v;         ///< place in the patch's [0, 1]^2
  Vec3 centre;           ///< S(0), model units
  std::array<Vec3, 2> dual;
  Vec3 normal;
  Matrix2 spread{};
  std::array<double, 2> tilt{};
  std::array<double, 2> dual_length{};
  std::array<double, 2> reach{};  ///< bounds of |S_u|, |S_v| by the cell's own parameters
};

/// The numbers of a cell of `patch`.
FlatCell flat_cell(const Cell& cell, const RationalBezierPatch& patch);

/// Whether one step of Newton's method is good in the cell.
bool is_flat(const FlatCell& cell);

}  // namespace blossom
