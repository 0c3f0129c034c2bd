// SPDX-License-Identifier: LGPL-2.1-or-later
// Watertight pieces of lower degrees.
//
// Over a trim of degree q the degree of a triangle is q (n + m), q times that of a straight one: 24
// on a patch of degree 4 x 4. Beside trims, where triangles are small, hardly more than degree
// n + m is in them; the rest would only make files large.

#pragma once

#include <vector>

#include "core/forms/surface.h"
#include "core/regions/triangle_lowering.h"
#include "core/watertight/watertight_pieces.h"

namespace blossom {

/// Lowers degrees; matrices are kept for the next call.
class DegreeLowering {
 public:
  /// Inner sides get the lowest degree within the tolerance, or where a rectangle has them their
  /// own, which is at most n + m, as they are straight in the parameters of their patch. Triangles
  /// get the lowest degree that is not below those of their sides and leaves them within the
  /// tolerance, or else the highest degree; the distance is their `moved` then.
  ///
  /// surfaces    of the faces, polynomial
  /// highest     degree of triangles, if their sides allow
  /// tolerance   model units
  void lower(WatertightPieces& pieces, const std::vector<BezierSurface>& surfaces, int highest,
             double tolerance);

 private:
  void lower_triangle(WatertightPiece& piece, const std::vector<WatertightSide>& sides, int highest,
                      double tolerance);

  TriangleLowering lowered_;
};

}  // namespace blossom
