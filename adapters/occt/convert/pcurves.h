// SPDX-License-Identifier: LGPL-2.1-or-later
// Parametric curves of edges to planar curves of the core.

#pragma once

#include <array>

#include <Geom2d_Curve.hxx>

#include "core/forms/spline.h"
#include "core/plane/even_line.h"
#include "core/plane/planar_curves.h"

namespace blossom::occt {

/// The curve over a finite range as rational Bezier spans with its own parameters: lines,
/// circles, ellipses and B-splines exactly, others within 1e-9 of the size of the piece.
/// throws   BadModel if the range is not finite or empty, or the curve cannot be converted
PlanarCurve planar_curve(const Handle(Geom2d_Curve) & curve, const Interval& range);

/// Whether a curve, or what it is a part of, is a periodic B-spline.
bool is_periodic_spline(const Handle(Geom2d_Curve) & curve);

/// The box of a curve over a finite range, in u and in v; of splines it may be a little wider.
std::array<Interval, 2> bounds_of(const Handle(Geom2d_Curve) & curve, const Interval& range);

/// The spline with the same parameter, without idle knots, an even line as a line: but where Open
/// CASCADE would take it for an isoparametric line that it is not, as a spline of one span.
///
/// scale    model units per parameter, in u and in v; about
/// throws   Failure if Open CASCADE refuses the knots or the number of points
Handle(Geom2d_Curve) simplest_to_occt(const Spline2& spline, const Vec2& scale);

}  // namespace blossom::occt
