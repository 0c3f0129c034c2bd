// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces of revolution and of extrusion as sets of points: a plane curve that is turned about an
// axis, or moved along one.
//
// Whether two of them are one, turned about their axis or moved along it, is told by their curves.

#pragma once

#include <optional>

#include "core/base/tolerances.h"
#include "core/forms/curve_spans.h"
#include "core/forms/elementary.h"
#include "core/math/vec.h"

namespace blossom {

/// A curve is in the plane z = 0 of a frame, model units:
///
///   turned   x: the distance from the axis, y: the height along it, from the centre on
///   moved    x, y: along `x` and cross(axis, x), from the centre on
struct SweptProfile {
  bool turned = false;
  Vec3 centre;
  Vec3 axis{0, 0, 1};  ///< a unit vector
  Vec3 x{1, 0, 0};     ///< a unit vector across the axis; of a turned curve without meaning
  CurveSpans curve{};
  double error = 0;  ///< bound on the distance of the surface from what is written here
};

/// The surface of a curve turned about a line; nothing if the curve is not to rounding in a plane
/// through the line and on one side of it.
std::optional<SweptProfile> turned_profile(const CurveSpans& curve, const Vec3& centre,
                                           const Vec3& axis);

/// The surface of a curve moved along a direction without end; nothing if the curve runs along it.
std::optional<SweptProfile> moved_profile(const CurveSpans& curve, const Vec3& axis);

/// A bound on the distance of two swept surfaces in a ball, either from the other, wherever their
/// curves are both there, if these have nothing in common but runs along which they are one. Each
/// run goes on until one of the curves ends: the surfaces do not part but at borders.
///
/// With s the sine of the angle between the axes, q_a and q_b their points next to the ball's
/// centre c, r its radius:
///
///   turned   gap of the curves + |q_a - q_b| + pi s / 2 (r + |c - q_a|)
///   moved    gap of the curves, in the plane through c + r s / sqrt(1 - s^2)
///
/// tolerances   within which curves run along each other
/// returns      nothing if the surfaces are not one, or it is not known; the curves' `error` is
///              added, and roundings
std::optional<double> gap_of_one_sweep(const SweptProfile& a, const SweptProfile& b,
                                       const Ball& ball, const Tolerances& tolerances);

}  // namespace blossom
