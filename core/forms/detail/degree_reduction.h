// SPDX-License-Identifier: LGPL-2.1-or-later
// The matrix of degree reduction.

#pragma once

#include "core/math/grid.h"

namespace blossom::detail {

/// R, (lower + 1) x (degree + 1): the points of the curve of degree `lower` that is nearest to the
/// curve of degree `degree` in the mean, with the same end points (none for lower = 0).
///
/// In Bernstein form the nearest in the mean square over [0, 1] is the nearest of the elevated
/// points, so R solves a linear least-squares problem. Source: Lutterkort, Peters, Reif 1999.
Grid<double> reduction_matrix(int degree, int lower);

}  // namespace blossom::detail
