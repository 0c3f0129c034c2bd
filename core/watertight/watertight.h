// SPDX-License-Identifier: LGPL-2.1-or-later
// Trimmed faces that meet along edges as patches and triangles that meet without gaps.
//
// Along an edge two trimmed surfaces agree only within a tolerance. Here each piece of an edge
// becomes one polynomial Bezier curve, and the triangles on both sides get its control points, bit
// for bit, in the place of their own. So the surfaces leave their place a little, by no more than
// the largest way of a control point, and only in the triangles at edges; all else stays on the
// surfaces.

#pragma once

#include "core/watertight/watertight_pieces.h"

namespace blossom {

/// The faces as pieces with common sides.
///
///   (1) along an edge the control points of the pieces' sides are those of the side, elevated to
///   one
///       degree and equal bit for bit
///   (2) inside of a face sides of equal degree are equal bit for bit, others to rounding
///   (3) no side ends in the middle of another
///   (4) triangles fold over nowhere but in those of `turned`: where the move of a side reaches
///       across a triangle, that moves with it, and so do its sides inside of the face
///
/// Rational surfaces become polynomial first, within a tenth of the tolerance
/// (polynomial_surface.h).
///
/// throws    InvalidInput if a number in the model names nothing, or as triangulated_region
/// Source: Farouki, Han, Hass, Sederberg 2004, but with curved triangles: perturbing their sides
/// stays within the error of the edge.
WatertightPieces watertight_pieces(const CommonModel& model, const WatertightOptions& options = {});

}  // namespace blossom
