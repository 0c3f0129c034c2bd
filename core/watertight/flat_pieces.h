// SPDX-License-Identifier: LGPL-2.1-or-later
// Watertight triangles that lie in planes.

#pragma once

#include <optional>

#include "core/math/vec.h"
#include "core/watertight/watertight_pieces.h"

namespace blossom {

/// Unit directions x and y; the piece turns counter-clockwise in them.
struct PiecePlane {
  Vec3 origin;
  Vec3 x;
  Vec3 y;
  double error = 0;  ///< bound on the distance of the piece and its sides from it, model units

  Vec2 at(const Vec3& p) const { return {dot(p - origin, x), dot(p - origin, y)}; }
};

/// Of the triangle of the corners, over its longest side; model units.
double height_of(const BezierTriangle& triangle);

/// The plane of a triangle whose control points, and those of its sides, lie within a distance of
/// one, and that turns nowhere over in it, by the coefficients of its Jacobian. None otherwise.
///
/// within   model units; the sides are no farther from the piece's own border, either
/// height   of the triangle of its corners, at least; model units
std::optional<PiecePlane> plane_of(const WatertightPieces& pieces, const WatertightPiece& piece,
                                   double within, double height);

}  // namespace blossom
