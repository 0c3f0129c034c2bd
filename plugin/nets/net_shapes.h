// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces and edges of Open CASCADE to nets and back.

#pragma once

#include <vector>

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include "plugin/nets/net.h"

namespace blossom::nets {

/// The Bezier spans of a face's surface over the box of its trims, row by row.
/// throws   occt::BadModel, naming the source
std::vector<Net> face_nets(const TopoDS_Face& face, const NetSource& source);

/// The Bezier spans of an edge's curve; none if it has no curve in space.
/// throws   occt::BadModel, naming the source
std::vector<Net> edge_nets(const TopoDS_Edge& edge, const NetSource& source);

/// A face on the net's surface, untrimmed, or an edge on its curve, in Bezier form. A triangle
/// becomes its collapsed_net.
/// throws   occt::BadModel, naming the source, if Open CASCADE has no such form: a triangle whose
///          degree is above kMaxDegree, a curve that is a point
TopoDS_Shape net_shape(const Net& net);

/// The lines of a control net: along rows and columns, or along the three directions of a triangle.
std::vector<std::vector<Vec3>> net_lines(const Net& net);

}  // namespace blossom::nets
