// SPDX-License-Identifier: LGPL-2.1-or-later
// Proven bounds on the distances between a line or conic and its images on two elementary surfaces,
// by closed forms: for the lines and circles of the surfaces, and all conics on planes and
// cylinders. `deviation.h` bounds any images on any surfaces, with a thousand times the work.

#pragma once

#include <optional>

#include "core/forms/elementary.h"
#include "core/results/result.h"

namespace blossom {

/// The conic's parameter is an angle or a length, and so are those of the surfaces. An image
/// follows the conic where one of them runs at the same rate, forward or backward, and
///
///   plane      any conic C: u = X (C - O), v = Y (C - O)
///   cylinder   an ellipse: u runs, v = Z (C - O)
///   others     lines and circles: one parameter runs, the other is fixed
///
/// The image of these laws and the conic are both P + p cos t + q sin t, or both P + t D. The bound
/// is that on their difference, with what the spline in the chart is off its law, as far as its
/// control points are, by the surface's speed.
///
/// curve     its three splines are Bezier pieces of degree 5 with the same knots; of other members
///           only the conic is read, which it must have
/// within    model units
/// returns   proven bounds; nothing if they are wider than `within`, as where an image follows the
///           conic in another way
/// accuracy  of `between` no better than the sum of the other two
///
/// Source: Davis 1963, theorem 3.5.1.
std::optional<Deviation> conic_deviation(const IntersectionCurve& curve, const ElementaryChart& a,
                                         const ElementaryChart& b, double within);

}  // namespace blossom
