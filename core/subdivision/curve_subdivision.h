// SPDX-License-Identifier: LGPL-2.1-or-later
// Cutting Bezier curves into Bezier curves.

#pragma once

#include <span>
#include <vector>

#include "core/forms/curve.h"
#include "core/math/interval.h"
#include "core/subdivision/subdivision_matrix.h"

namespace blossom {

/// A piece of a curve: S p.
///
/// piece        curve parameters; from > to reverses, outside [0, 1] extends
/// returns      n + 1 points, model units
/// throws       InvalidInput if an end is not finite or the degree is not 0..kMaxDegree
/// accuracy     curve_subdivision_error(n) inside [0, 1]
///
/// Source: Vlachkova 2025, Theorem 1, in the Bernstein basis.
template <class Point>
BezierCurveOf<Point> sub_curve(const BezierCurveOf<Point>& curve, const Interval& piece);

/// All pieces between neighbouring cuts.
///
/// cuts         increasing parameters, at least 2
/// returns      (cuts - 1) curves; neighbours share their end point bit for bit
/// throws       as above, and InvalidInput if there are fewer than 2 cuts or they do not increase
template <class Point>
std::vector<BezierCurveOf<Point>> subdivide(const BezierCurveOf<Point>& curve,
                                            std::span<const double> cuts);

}  // namespace blossom
