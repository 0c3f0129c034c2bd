// SPDX-License-Identifier: LGPL-2.1-or-later
// Bounds of the second derivatives of a cell of a surface.

#pragma once

#include "core/cells/cell_tree.h"

namespace blossom {

struct SecondDerivatives {
  VectorBounds uu, uv, vv;  ///< by the cell's own [0, 1] parameters
};

/// Bounds that contain the rounding of the cell's net. With S = X / w and the origin O moved into
/// the cell, X' = X - w O:
///
///   S_uv = (X'_uv - w_u S_v - w_v S_u - (S - O) w_uv) / w
///
/// and likewise for uu and vv, so that the loose terms are of higher order in the cell's size.
///
/// shape   of the net; 3 planes: w = 1
SecondDerivatives second_derivatives(const Cell& cell, const NetShape& shape);

}  // namespace blossom
