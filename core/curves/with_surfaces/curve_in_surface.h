// SPDX-License-Identifier: LGPL-2.1-or-later
// Pieces of a curve that lie in a surface, proven by composition.
//
// From feet of points of the curve comes a cubic of the surface's parameters; the surface along it
// is a Bezier curve by composition, and comparing coefficients bounds its distance from the curve.

#pragma once

#include <vector>

#include "core/curves/with_surfaces/curve_surface_search.h"

namespace blossom {

struct CurveInSurface {
  CurveSurfaceContact piece;  ///< with the box of the parameters
  Vec2 uv_from, uv_to;        ///< local, on the piece's patch
  double gap = 0;             ///< bound on the distance along it, model units
};

/// All such pieces down to a 64th of a span, in order; where the work or the steps end, those that
/// were found till then. What is missing is left to the search, which proves no runs.
///
/// most   steps of the work, at most
std::vector<CurveInSurface> pieces_in_surface(const CurveTree& curve, SurfaceTrees& surface,
                                              SharedWork& work, long most, double tolerance);

/// A place of the surface within the tolerance of a point.
struct SurfaceFoot {
  int patch = 0;
  Vec2 uv;
  double distance = 0;
};

/// The foot of a point on a patch, from a start, kept on the patch.
SurfaceFoot foot_on(const SurfaceTrees& surface, int patch, const Vec2& start, const Vec3& point);

}  // namespace blossom
