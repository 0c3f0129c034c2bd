// SPDX-License-Identifier: LGPL-2.1-or-later
// The curves along the sides of a watertight piece, and flat ones.

#pragma once

#include "core/watertight/watertight_pieces.h"

namespace blossom {

/// The curve along side k, from vertex k to the next one: the outermost points of the piece's form.
BezierCurve side_curve(const WatertightPiece& piece, int k);

/// The same points replaced. The curve has the degree of the piece there.
void set_side_curve(WatertightPiece& piece, int k, const BezierCurve& curve);

/// The same triangle with degree 1 if it is straight and runs evenly, to rounding, whatever the
/// patch says that it comes from.
BezierTriangle flat_if_it_is(const BezierTriangle& triangle);

}  // namespace blossom
