// SPDX-License-Identifier: LGPL-2.1-or-later
// Whether two surfaces are one and the same, told by their control points without any search.

#pragma once

#include <optional>

#include "core/forms/surface.h"
#include "core/math/vec.h"

namespace blossom {

/// An affine map between the parameters of two surfaces, direction by direction:
///   result[k] = slope[k] uv[k] + offset[k],  with uv[1 - k] where the directions are exchanged.
struct ChartMap {
  bool exchanged = false;  ///< u of the one runs along v of the other
  Vec2 slope{1, 1};        ///< negative where a direction is reversed
  Vec2 offset{0, 0};

  Vec2 operator()(const Vec2& uv) const {
    return exchanged ? Vec2{slope[0] * uv[1] + offset[0], slope[1] * uv[0] + offset[1]}
                     : Vec2{slope[0] * uv[0] + offset[0], slope[1] * uv[1] + offset[1]};
  }
};

struct SurfaceMatch {
  ChartMap map;    ///< from the parameters of the first surface to those of the second
  double gap = 0;  ///< bound on |a(uv) - b(map(uv))| but for the knots' rounding, model units;
                   ///< 0: the control points are the same numbers
};

/// The map under which two surfaces agree, directions perhaps exchanged or reversed.
///
///   |a(uv) - b(map(uv))| <= max_i |p_i - q_i| + eta d
///
/// for control points p_i, q_i at corresponding places: with equal weights both points are the same
/// convex combination of them. 1 + eta is the largest quotient of their weights' ratios, and moves
/// it by the sum of |lambda_i - mu_i| <= eta diameters d. Roundings of the bound are added unless
/// all numbers agree, the `error` of both surfaces in any case. Spans lie alike up to rounding.
///
/// within    largest bound, but for the `error` of both, that counts as agreement, model units
/// returns   nothing if no map gives so small a bound: they may still be one surface, in other
///           parameters or divided otherwise
std::optional<SurfaceMatch> match(const BezierSurface& a, const BezierSurface& b, double within);

}  // namespace blossom
