// SPDX-License-Identifier: LGPL-2.1-or-later
// Cutting tensor-product Bezier patches into Bezier patches.
//
// The points of a sub-patch are S_u P S_v^T, where P is the net of the patch and S the
// subdivision matrix of one direction. The matrices depend on the degrees and the cuts alone, so
// a whole grid of cells shares them.

#pragma once

#include <span>

#include "core/forms/patch.h"
#include "core/math/grid.h"
#include "core/math/interval.h"
#include "core/subdivision/subdivision_matrix.h"

namespace blossom {

/// The piece of a patch on a rectangle.
///
/// u, v         patch parameters; from > to reverses, outside [0, 1] extends
/// returns      (n + 1) x (m + 1) points, model units
/// throws       InvalidInput if an end is not finite or a degree is not 0..kMaxDegree
/// accuracy     subdivision_error(max(n, m)) inside the unit square
///
/// Source: Vlachkova 2025, Theorem 2, in the Bernstein basis.
template <class Point>
BezierPatchOf<Point> sub_patch(const BezierPatchOf<Point>& patch, const Interval& u,
                               const Interval& v);

/// All cells of a grid of cuts over a patch.
///
/// patch        (n + 1) x (m + 1) points, model units
/// u_cuts       increasing parameters, at least 2; cell i is [u_i, u_(i+1)]
/// v_cuts       likewise
/// returns      (u_cuts - 1) x (v_cuts - 1) patches of the same degrees; neighbours share their
///              border points bit for bit
/// throws       InvalidInput if there are fewer than 2 cuts or they do not increase
/// accuracy     subdivision_error(max(n, m)) inside the unit square
///
/// Source: Vlachkova 2025, Theorem 2, in the Bernstein basis.
template <class Point>
Grid<BezierPatchOf<Point>> subdivide(const BezierPatchOf<Point>& patch,
                                     std::span<const double> u_cuts,
                                     std::span<const double> v_cuts);

}  // namespace blossom
