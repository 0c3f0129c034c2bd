// SPDX-License-Identifier: LGPL-2.1-or-later
// Points whose convex hull holds a whole edge or face: bounds without any conversion.

#pragma once

#include <vector>

#include <Bnd_Box.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Trsf.hxx>

#include "core/distance.h"
#include "core/math/vec.h"

namespace blossom::occt {

/// Where the edge's curve runs, without the edge's own location. False if its type has no control
/// points (offset curves and the like); then nothing is added that means anything.
/// throws   BadModel if the edge has no curve in space
bool add_hull(const TopoDS_Edge& edge, std::vector<Vec3>& hull);

/// The same of what the trims leave of a face's surface: of its control points, or of its pcurves'
/// put on planes, and turned about the axis of surfaces of revolution. With what snapping
/// parameters to seams may add. False if the type of the surface or of a pcurve has none, or the
/// face has no pcurve.
/// throws   BadModel if the face has no surface
bool add_hull(const TopoDS_Face& face, std::vector<Vec3>& hull);

/// Whether there are points, none of them so far away that it stands for no end at all.
bool has_end(const std::vector<Vec3>& hull);

/// The points where they are placed, with a margin for roundings.
HullBound placed_hull(std::vector<Vec3> hull, const gp_Trsf& place);

enum class BoxKind {
  Quick,
  Least,  ///< minimized over the shape, which takes milliseconds
};

/// A box that holds a shape with its tolerances: Open CASCADE's, but for faces on tori, of which
/// that may hold a part alone. Void if there is nothing in the shape.
Bnd_Box bounds_of(const TopoDS_Shape& shape, BoxKind kind = BoxKind::Quick);

/// The middle of its quick box; the origin of what has none, or an endless one.
Vec3 middle_of(const TopoDS_Shape& shape);

}  // namespace blossom::occt
