// SPDX-License-Identifier: LGPL-2.1-or-later
// The rows beside a border, made to have the weights of the border.
//
// Notation: as in border_rows.h; q the weight of the border, W(y) = sum_j D_j,w y^j / j! the weight
// across it.

#pragma once

#include <vector>

#include "core/blending/border_rows.h"

namespace blossom {

/// The degree that `level_weights` leads to.
int level_degree(const std::vector<BorderPiece>& pieces);

/// Multiplies the pieces of one border by a factor f(x, y) such that the weights of D_1, D_2, ...
/// are 0; the surface stays where it is. Where these are constant multiples of q along the whole
/// border,
///   f = q / W,   which is a constant series in y,
/// else f = q^(k + 1) / W up to y^k, whose coefficients are polynomials of degree k times that of
/// q, and the border itself gets the factor q^k.
void level_weights(std::vector<BorderPiece>& pieces);

}  // namespace blossom
