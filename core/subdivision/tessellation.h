// SPDX-License-Identifier: LGPL-2.1-or-later
// Points on a patch in a uniform grid that is fine enough for a chord tolerance.
//
// A cell of the grid stands for two right triangles with legs l_u, l_v in the parameters. No
// point of the patch is farther from the point with the same parameters on its triangle than
//
//   (l_u^2 M_uu + 2 l_u l_v M_uv + l_v^2 M_vv) / 8
//
// where M bounds the length of a second derivative. Differences of the net give the bounds; for
// a rational patch they follow from those of numerator and denominator by the quotient rule.

#pragma once

#include "core/forms/patch.h"
#include "core/math/grid.h"
#include "core/math/vec.h"

namespace blossom {

/// Bounds of the lengths of the second derivatives on [0, 1]^2, model units.
struct SecondDerivativeBounds {
  double uu = 0;
  double uv = 0;
  double vv = 0;
};

/// Number of cells in each direction.
struct CellCount {
  int u = 1;
  int v = 1;
};

/// Highest number of cells in a direction that `cells_for_tolerance` answers.
inline constexpr int kMaxCells = 4096;

/// throws    InvalidInput if a degree is not 0..kMaxDegree or a weight is not positive
SecondDerivativeBounds second_derivative_bounds(const RationalBezierPatch& patch);

/// The distance of the formula above for a uniform grid. Model units.
double chord_bound(const SecondDerivativeBounds& bounds, const CellCount& cells);

/// Cells for which `chord_bound` is at most the tolerance, balanced between the directions.
///
/// tolerance   model units, positive
/// throws      InvalidInput if the tolerance is not positive and finite, or so small that a
///             direction would take more than kMaxCells; and as second_derivative_bounds
///
/// Source: Filip, Magedson, Markot 1986.
CellCount cells_for_tolerance(const RationalBezierPatch& patch, double tolerance);

/// Points at u = i / cells.u, v = j / cells.v.
///
/// returns     (cells.u + 1) x (cells.v + 1) points in space, model units; those on a border
///             depend on the border's control points alone
/// throws      InvalidInput if a number of cells is not positive; and as above
Grid<Vec3> points_on_grid(const RationalBezierPatch& patch, const CellCount& cells);

}  // namespace blossom
