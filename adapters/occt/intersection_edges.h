// SPDX-License-Identifier: LGPL-2.1-or-later
// From shapes to the lists of faces that intersect() takes, and from its answer to a shape.

#pragma once

#include <functional>
#include <string>
#include <vector>

#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include "adapters/occt/intersection.h"

namespace blossom::occt {

/// The faces of a shape in the order of TopExp::MapShapes: face number k is at place k - 1.
std::vector<TopoDS_Face> faces_of(const TopoDS_Shape& shape);

/// The edges of a shape that are in it beside its faces, each once; without degenerated ones.
std::vector<TopoDS_Edge> loose_edges_of(const TopoDS_Shape& shape);

struct JoinedIntersection {
  TopoDS_Compound wires;
  std::vector<std::string> lost;  ///< why borders of common regions are not all in it
};

/// What two shapes have in common as wires of edges with common vertices, each stretch once, and
/// vertices at isolated contacts, as `joined_curves` has them. Of common regions of two faces these
/// are the borders: where faces end freely, or in a seam, or the region goes on in the next face,
/// what of their edges lies in the other face, within the tolerance of the intersection. These are
/// looked for within its time limit, once more.
/// a, b        the lists that were intersected; one list twice for `self_intersect`
/// cancelled   asked now and then: borders that are not yet found are lost
/// throws      Failure if Open CASCADE refuses one
JoinedIntersection joined_intersection(const ShapeIntersection& found,
                                       const std::vector<TopoDS_Face>& a,
                                       const std::vector<TopoDS_Face>& b,
                                       const std::function<bool()>& cancelled = {});

}  // namespace blossom::occt
