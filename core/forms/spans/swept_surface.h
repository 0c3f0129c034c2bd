// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces of revolution and of extrusion as Bezier patches.
//
// Over an arc with Bezier points (C_i, S_i, W_i) of w (cos, sin, 1), a meridian's homogeneous point
// at angle 0, split into its part along the axis (with the axis's origin) and its part across,
// gives the points
//
//   (W_i along + C_i across + S_i across', W_i w),   across' = axis x across

#pragma once

#include <vector>

#include "core/forms/curve_spans.h"
#include "core/forms/spans/arc_spans.h"
#include "core/forms/surface.h"
#include "core/math/interval.h"
#include "core/math/vec.h"

namespace blossom {

/// A homogeneous point of a meridian, ready to be turned.
struct MeridianPoint {
  Vec3 along;
  Vec3 across;       ///< at angle 0
  Vec3 across_next;  ///< at a quarter of a turn
  double weight;
};

struct MeridianSpan {
  std::vector<MeridianPoint> points;
  Interval place;
};

/// What is turned about an axis; its parameters are the surface's v.
struct Meridian {
  std::vector<MeridianSpan> spans;
  ParameterLaw law = ParameterLaw::Linear;
  double error = 0;  ///< of the curve it stands for, model units
};

/// The axes of an elementary surface, which may be left-handed; the meridian at angle 0 lies in the
/// plane of x and z.
struct MeridianFrame {
  Vec3 origin, x, y, z;
};

/// A straight meridian: the point (radius, height) is (radius, 0) + v (d_radius, d_height).
Meridian straight_meridian(const MeridianFrame& frame, double radius, double d_radius,
                           double d_height, const Interval& v);

/// A circle of radius `minor` about (`major`, 0); v is its angle, radians.
Meridian circular_meridian(const MeridianFrame& frame, double major, double minor,
                           const Interval& v, ArcCuts cuts = ArcCuts::Even);

/// Any curve, to be turned about an axis through `origin` of direction `axis`, unit.
Meridian curved_meridian(const CurveSpans& curve, const Vec3& origin, const Vec3& axis);

/// The meridian turned; u is the angle, radians. What `rational` and `closed_u`, `closed_v` say is
/// left to the caller, here and below.
BezierSurface turned_surface(const Meridian& meridian, const Interval& angles,
                             ArcCuts cuts = ArcCuts::Even);

/// curve(u) + v direction, of degree 1 in v.
BezierSurface extruded_surface(const CurveSpans& curve, const Vec3& direction, const Interval& v);

}  // namespace blossom
