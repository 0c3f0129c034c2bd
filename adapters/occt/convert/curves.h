// SPDX-License-Identifier: LGPL-2.1-or-later
// Curves of Open CASCADE to core forms and back.

#pragma once

#include <Adaptor3d_Curve.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Curve.hxx>
#include <TopoDS_Edge.hxx>

#include "core/base/tolerances.h"
#include "core/forms/conic.h"
#include "core/forms/curve.h"
#include "core/forms/curve_spans.h"
#include "core/forms/spans/arc_spans.h"
#include "core/forms/spline.h"
#include "core/math/interval.h"

namespace blossom::occt {

/// The Bezier points of a Bezier curve: bit for bit when it is polynomial, else (wx, wy, wz, w),
/// with what surfaces.h says about the way back.
RationalBezierCurve from_occt(const Geom_BezierCurve& curve);

/// Any curve on a finite parameter range as Bezier spans: B-splines split at their knots, conics
/// exactly, offset curves within `tolerance` (model units); `error` is then twice the largest
/// distance sampled, and above `tolerance` only if a 1024th of the range is still too long.
/// throws   BadModel if the range is not finite, empty or outside of the curve, a number of the
///          curve is not finite or a weight not positive
CurveSpans bezier_spans(const Handle(Geom_Curve) & curve, const Interval& range,
                        double tolerance = Tolerances{}.point);

/// The same of a curve in the plane, z = 0.
/// throws   BadModel as above
CurveSpans bezier_spans(const Handle(Geom2d_Curve) & curve, const Interval& range,
                        double tolerance = Tolerances{}.point);

/// The curve of an edge in model space, over the edge's range. The edge's orientation is left out:
/// parameters are the curve's.
/// throws   BadModel if the edge has no curve in space, or as above
CurveSpans bezier_spans(const TopoDS_Edge& edge, double tolerance = Tolerances{}.point);

/// As of a curve in space, with no other laws than surfaces and nets have: hyperbolas are
/// approximated, too.
CurveSpans profile_spans(const Handle(Geom_Curve) & curve, const Interval& range,
                         double tolerance = Tolerances{}.point, ArcCuts cuts = ArcCuts::Even);

/// A Bezier curve with the same points; polynomial, and bit for bit, when all weights are 1.
/// throws   Failure if Open CASCADE refuses the points
Handle(Geom_BezierCurve) to_occt(const RationalBezierCurve& curve);

/// The same knots and points, bit for bit.
/// throws   Failure if Open CASCADE refuses the knots or the number of points
Handle(Geom_BSplineCurve) to_occt(const Spline& spline);
Handle(Geom2d_BSplineCurve) to_occt(const Spline2& spline);

/// The whole line or conic with the same parameter; of a hyperbola the branch.
/// throws   Failure if Open CASCADE refuses its axes or lengths
Handle(Geom_Curve) to_occt(const Conic& conic);

/// The curve without trims; they do not change its parameter.
Handle(Geom_Curve) basis_of(Handle(Geom_Curve) curve);
Handle(Geom2d_Curve) basis_of(Handle(Geom2d_Curve) curve);

/// Of a periodic B-spline that is used beyond its first period the part over a range, as a B-spline
/// without a period that has the same parameter; null for every other curve. Open CASCADE's
/// adaptors find the knots of the first period alone, so that lengths and integrals go wrong in
/// others.
Handle(Geom_BSplineCurve)
    part_beyond_period(const Handle(Geom_Curve) & curve, const Interval& range);
Handle(Geom2d_BSplineCurve)
    part_beyond_period(const Handle(Geom2d_Curve) & curve, const Interval& range);

/// Puts such parts in the place of an edge's curves, in space and in the parameters of faces.
/// edge   of a result: shapes that have it in common see the change
void leave_periods(const TopoDS_Edge& edge);

/// The length of a curve over a range of its parameter, model units; to 1e-7 of it.
double curve_length(const Adaptor3d_Curve& curve, const Interval& range);

/// The length of an edge's curve in space, likewise; infinite if there is none.
double edge_length(const TopoDS_Edge& edge);

}  // namespace blossom::occt
