// SPDX-License-Identifier: LGPL-2.1-or-later
// A shape as the core meshes it.

#pragma once

#include <string>
#include <vector>

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>

#include "core/tessellation/shape_model.h"

namespace blossom::occt {

struct ReadShape {
  ShapeModel model;  ///< faces in the order of TopExp::MapShapes; without borders where refused
  TopTools_IndexedMapOfShape edges;   ///< of the model's edges, by number + 1
  std::vector<std::string> refusals;  ///< of each face, why it cannot be meshed; mostly empty
};

/// Edges follow their curves in space, one that has none the face's own.
///
/// fine   how well curves and surfaces are to be converted that are not exact; model units
ReadShape read_shape(const TopoDS_Shape& shape, double fine);

}  // namespace blossom::occt
