// SPDX-License-Identifier: LGPL-2.1-or-later
// Points of a chain, dense enough that quintic Hermite pieces between them are the curve.

#pragma once

#include <vector>

#include "core/base/work_limit.h"
#include "core/forms/conic.h"
#include "core/forms/surface.h"
#include "core/tracing/spline_fit.h"
#include "core/tracing/trace.h"

namespace blossom {

/// A traced point: where it is on the chain and on the curve.
struct Site {
  double station = 0;
  double parameter = 0;  ///< of the curve: arc length, or that of its conic
  double length = 0;     ///< of the curve up to there, model units
  TracePoint point;
};

/// A part of a chain along which the curve is smooth in space and in both charts.
struct SmoothRun {
  std::vector<Site> sites;           ///< at least 2, in order
  std::vector<QuinticPiece> pieces;  ///< between neighbouring sites
  std::vector<double> errors;        ///< of each piece: largest gap of the images over the wanted
  int multiplicity = 0;              ///< of the knot at the end: 3 curvature, 4 tangent, 5 kink
};

/// Distances between the three images of a point.
struct Gaps {
  double a = 0, b = 0;  ///< from the point in space to its image on a surface, model units
  double between = 0;   ///< between the images
};

/// The seven coordinates of a point, and back.
Vec7 seven(const Vec3& x, const Vec2& a, const Vec2& b);
Vec3 space(const Vec7& x);
Vec2 chart_a(const Vec7& x);
Vec2 chart_b(const Vec7& x);

/// The gaps of the point with these seven coordinates. With a conic those from its point at the
/// parameter, added to that point's distance from the given one.
Gaps gaps_at(const BezierSurface& a, const BezierSurface& b, const Vec7& x,
             const Conic* conic = nullptr, double parameter = 0);

/// What is asked of the three images. Model units.
struct Agreement {
  double gap;           ///< wanted
  double rounding = 0;  ///< of coordinates; the images need not be closer at any angle
};

/// The gaps as a part of those wanted; at a small angle between the surfaces, whose sine
/// is given, the images of the charts have to be closer. 1 is just good enough.
double relative_gap(const Gaps& gaps, const Agreement& wanted, double sine);

/// The sites of a chain. Pieces are halved until the gaps of their images, and the distance of
/// the piece's middle to the traced one, are below `limit` times the wanted ones.
///
/// wanted    agreement of the three images
/// limit     1: the pieces are as good as wanted
/// conic     what the curve is in space, which gives the parameter; null: that is arc length
/// work      when to give up; null: never
/// returns   in order, each with a piece or more; nothing if the chain has no length, it is late or
///           the conic's parameter does not grow along the chain
std::vector<SmoothRun> smooth_runs(const ChainTracer& tracer, const BezierSurface& a,
                                   const BezierSurface& b, const Agreement& wanted, double limit,
                                   const Conic* conic = nullptr, const WorkLimit* work = nullptr);

}  // namespace blossom
