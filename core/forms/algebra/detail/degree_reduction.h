// SPDX-License-Identifier: LGPL-2.1-or-later
// The matrix of degree reduction.

#pragma once

#include "core/math/grid.h"

namespace blossom::detail {

/// R, (lower + 1) x (degree + 1): the points of the curve of degree `lower` whose elevated points
/// are nearest to those of the curve of degree `degree` in the mean square, with the same end
/// points (none for lower = 0).
///
/// Without conditions on the ends, that curve is the nearest in the mean square over [0, 1].
/// Source: Lutterkort, Peters, Reif 1999.
Grid<double> reduction_matrix(int degree, int lower);

/// The same for triangles, rows and columns in the order of their points; on the sides it is R.
Grid<double> triangle_reduction_matrix(int degree, int lower);

}  // namespace blossom::detail
