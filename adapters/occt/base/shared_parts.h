// SPDX-License-Identifier: LGPL-2.1-or-later
// Which edges and faces of a shape share what.

#pragma once

#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS_Shape.hxx>

namespace blossom::occt {

/// For each edge and vertex of a shape those that use it, each once; none where nothing does.
struct SharedParts {
  using Users = TopTools_IndexedDataMapOfShapeListOfShape;

  Users faces_of_edges, edges_of_vertices, faces_of_vertices;

  explicit SharedParts(const TopoDS_Shape& shape) {
    TopExp::MapShapesAndUniqueAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_of_edges);
    TopExp::MapShapesAndUniqueAncestors(shape, TopAbs_VERTEX, TopAbs_EDGE, edges_of_vertices);
    TopExp::MapShapesAndUniqueAncestors(shape, TopAbs_VERTEX, TopAbs_FACE, faces_of_vertices);
  }
};

}  // namespace blossom::occt
