// SPDX-License-Identifier: LGPL-2.1-or-later
// The area of trimmed faces and the volume under them (`core/topology/surface_integrals.h`).

#pragma once

#include <span>

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include "core/math/interval.h"
#include "core/math/vec.h"
#include "core/topology/surface_integrals.h"

namespace blossom::occt {

/// The area of a face, square model units.
///
/// cells     cells that each span starts with; more of them check the result
/// accuracy  1e-10 relative where the surface is smooth between its knots; gaps of wires in the
///           chart within the edges' tolerances count for what they are
/// throws    BadModel if the face has no wire or an edge has no pcurve
double area(const TopoDS_Face& face, int cells = 1);

/// The volume of the cone from a point over a face, cubic model units; negative where the oriented
/// normal points to the apex. The cones of a closed shell add up to the volume that it encloses.
///
///   V = integral over the chart of (S - apex) . (S_u x S_v) / 3
///
/// enough     an error that does not matter, of each of the integrals that are added up, cubic
///            model units; 0: none
/// accuracy   as the area, relative to the integral of the integrand's absolute value, and 1e-12 of
///            the area times the coordinates
/// throws     as area
double cone_volume(const TopoDS_Face& face, const Vec3& apex, double enough = 0);

/// The volume of the cone over the strips between a face and its edges' curves
/// (border_strips.h), with the sign of the face's own cone. With them the sum over a closed
/// shell does not depend on the apex where its edges have a tolerance; without them pieces of a
/// face add up to it.
/// throws     as area
double cone_volume_beside(const TopoDS_Face& face, const Vec3& apex);

/// The same along a part of one edge alone.
///
/// edge   as the forward face uses it
double cone_volume_beside(const TopoDS_Face& face, const TopoDS_Edge& edge, const Interval& part,
                          const Vec3& apex);

/// The moments of the cone from a point over a face, with the sign of its volume and with the
/// strips of `cone_volume_beside`.
///
/// accuracy   1e-10 of the integrals of the integrands' absolute values, as the area
/// throws     as area
ConeMoments cone_moments(const TopoDS_Face& face, const Vec3& apex);

/// The integral over a face of S - origin, model units^3: its area times what its centre is from
/// there.
/// accuracy, throws   as cone_moments
Vec3 area_moment(const TopoDS_Face& face, const Vec3& origin);

/// About the area within a closed polygon in the parameters of a face's surface, for summaries.
///
/// polygon   repeats its first corner; several loops one after the other as `joined_loops` makes
/// accuracy  that of the polygon, and of taking the middle line of each triangle for all of it
double polygon_area(const TopoDS_Face& face, std::span<const Vec2> polygon);

}  // namespace blossom::occt
