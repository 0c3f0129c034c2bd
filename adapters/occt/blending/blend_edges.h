// SPDX-License-Identifier: LGPL-2.1-or-later
// New edges with curves in the charts of the faces at them.

#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>

#include "core/math/interval.h"
#include "core/math/vec.h"

namespace blossom::occt {

/// A vertex at a point, with the least tolerance.
TopoDS_Vertex vertex_at(const Vec3& point);

Vec3 point_of(const TopoDS_Vertex& vertex);

/// Raises the tolerance of a vertex to cover a point with that of an edge that ends there.
void cover(const TopoDS_Vertex& vertex, const Vec3& point, double tolerance);

/// A forward edge on a curve; its vertices are made to cover its ends.
TopoDS_Edge edge_on(const Handle(Geom_Curve) & curve, const Interval& range,
                    const TopoDS_Vertex& from, const TopoDS_Vertex& to);

/// Gives an edge its curve in the chart of a face's surface, with the edge's parameter. Raises the
/// tolerances of the edge and its vertices to what the curves are apart, at samples, with a margin.
void add_chart(const TopoDS_Edge& edge, const Handle(Geom2d_Curve) & chart,
               const TopoDS_Face& face);

/// The same for an edge in which a closed surface meets itself. The first curve is that of the
/// forward edge.
void add_seam_charts(const TopoDS_Edge& edge, const Handle(Geom2d_Curve) & forward,
                     const Handle(Geom2d_Curve) & reversed, const TopoDS_Face& face);

/// The parameter of the point of a curve nearest to a point, by Newton's method from the nearest of
/// samples; within the range.
double nearest_on(const Handle(Geom_Curve) & curve, const Interval& range, const Vec3& point);

}  // namespace blossom::occt
