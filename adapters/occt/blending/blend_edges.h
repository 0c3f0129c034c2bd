// SPDX-License-Identifier: LGPL-2.1-or-later
// New edges with curves in the charts of the faces at them.

#pragma once

#include <array>

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>

#include "adapters/occt/blending/body_edges.h"
#include "core/math/interval.h"
#include "core/math/vec.h"

namespace blossom::occt {

/// An edge on a way, and whether it is walked forward.
struct PathEdge {
  TopoDS_Edge edge;  ///< forward
  bool forward = true;
};

/// A vertex at a point, with the least tolerance.
TopoDS_Vertex vertex_at(const Vec3& point);

Vec3 point_of(const TopoDS_Vertex& vertex);

/// The plane through three points, without wires, its normal to where they run against the clock.
TopoDS_Face plane_face(const Vec3& a, const Vec3& b, const Vec3& c);

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

/// The parameters after which a surface comes back to where it was, in u and v: periods, or the
/// range of a surface whose borders meet; 0 for none. A rectangle of a surface has those of all of
/// it, even where Open CASCADE gives it none.
std::array<double, 2> turns_of(const Handle(Geom_Surface) & given);

/// A curve in the chart of a face, moved by whole turns so that at a parameter it is as near as can
/// be to where the face is: inside of its box, and of its wires, if any is.
Handle(Geom2d_Curve)
    chart_near_face(const Handle(Geom2d_Curve) & chart, double at, const BodyEdges& body, int face);

/// The parameter of the point of a curve nearest to a point, by Newton's method from the nearest of
/// samples; within the range.
double nearest_on(const Handle(Geom_Curve) & curve, const Interval& range, const Vec3& point);

}  // namespace blossom::occt
