// SPDX-License-Identifier: LGPL-2.1-or-later
// The curves of edges in the parameters of faces.

#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include "core/math/interval.h"

namespace blossom::occt {

/// The parametric curve of an edge on a face, as `BRep_Tool::CurveOnSurface` has it; null if there
/// is none. Where a plane has none stored, lines, circles and ellipses in it are put into its
/// coordinates at once; Open CASCADE projects them through general machinery at every call.
///
/// edge    as oriented in the wire: a seam has two curves
/// range   of the curve's parameter, set
Handle(Geom2d_Curve)
    chart_curve_of(const TopoDS_Edge& edge, const TopoDS_Face& face, Interval& range);

/// The same for a line, circle or ellipse in the plane of a face, whether or not one is stored;
/// null for every other curve or surface. Its parameter is that of the curve in space.
Handle(Geom2d_Curve) plane_curve_of(const TopoDS_Edge& edge, const TopoDS_Face& face);
Handle(Geom2d_Curve) plane_curve_of(const Handle(Geom_Curve) & curve, const TopoDS_Face& face);

/// Whether a face has an edge twice, and so lies on both sides of it. An edge that keeps two curves
/// on a closed surface need not be a seam of each face there: two halves may have it once each.
bool is_seam(const TopoDS_Edge& edge, const TopoDS_Face& face);

/// Whether the edge keeps a curve in the parameters of the face's surface.
bool keeps_chart_curve(const TopoDS_Edge& edge, const TopoDS_Face& face);

}  // namespace blossom::occt
