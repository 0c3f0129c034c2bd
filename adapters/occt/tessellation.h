// SPDX-License-Identifier: LGPL-2.1-or-later
// Shapes as triangles within a proven distance.

#pragma once

#include <functional>
#include <vector>

#include <TopoDS_Shape.hxx>

#include "core/tessellation/mended_facets.h"
#include "core/tessellation/shape_facets.h"

namespace blossom::occt {

struct ShapeTessellation {
  ShapeFacets facets;  ///< faces in the order of TopExp::MapShapes
  /// Of each face: as the shape has it first it is turned from S_u x S_v, and so are its facets'
  /// outsides.
  std::vector<bool> reversed;
  std::vector<int> finer{};  ///< numbers from 0 on of faces that keep less than the deviation
  int looked = -1;           ///< see MendedFacets
};

/// The facets of all faces of a shape. Faces that share an edge share its corners; a face that
/// cannot be converted has an obstacle and no facets.
///
/// ask      see shape_facets
/// faults   see mended_facets; else nothing is mended
/// throws   InvalidInput as shape_facets
ShapeTessellation tessellation(const TopoDS_Shape& shape, const FacetOptions& options,
                               const std::function<bool()>& ask = {},
                               const FacetFaults& faults = {});

/// Triangles of all faces, turned as the shape has them, in numbers of the points; `face`, if
/// asked for, gets the number of each one's face, from 0 on.
std::vector<std::array<int, 3>> triangles_of(const ShapeTessellation& tessellation,
                                             std::vector<int>* face = nullptr);

}  // namespace blossom::occt
