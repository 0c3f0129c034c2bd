// SPDX-License-Identifier: LGPL-2.1-or-later
// From shapes to the lists of faces that intersect() takes, and from its answer to edges.

#pragma once

#include <vector>

#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include "adapters/occt/intersection.h"

namespace blossom::occt {

/// The faces of a shape in the order of TopExp::MapShapes: face number k is at place k - 1.
std::vector<TopoDS_Face> faces_of(const TopoDS_Shape& shape);

/// The edge on the 3D curve, with the tolerance of the curves; a closed one has one vertex.
/// throws   Failure if Open CASCADE makes no edge
TopoDS_Edge edge_of(const EdgeCurves& curves);

/// The edges of all curves and vertices at all isolated contacts, in the order of the answer.
/// throws   Failure as edge_of
TopoDS_Compound compound_of(const ShapeIntersection& found);

}  // namespace blossom::occt
