// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces that bound bodies, put together into closed shells and solids.

#pragma once

#include <string>
#include <vector>

#include <TopoDS_Face.hxx>
#include <TopoDS_Solid.hxx>

#include "core/base/work_limit.h"

namespace blossom::occt {

/// A face with the body behind it, and the volume of its cone over a common apex.
struct BoundingFace {
  TopoDS_Face face;
  double volume = 0;  ///< cubic model units, signed
};

/// By face a number of the body behind it. Edges are as for `solids_of`; a face may be there twice,
/// turned both ways, with a body on each side of it.
/// obstacle, limit, throws   as `solids_of`; no numbers if there is an obstacle
std::vector<std::size_t> bodies_of(const std::vector<BoundingFace>& faces, std::string& obstacle,
                                   const WorkLimit* limit = nullptr);

/// The solids that faces bound.
///
/// Faces hang together over their edges, each of which has to be used as often in one direction as
/// in the other. Where bodies touch in an edge, the two faces of one body's corner belong together,
/// so that the bodies stay apart. A shell that is turned inwards is a void of the smallest solid
/// around it. Solids and voids that enclose no more than the tolerances of their edges and vertices
/// cover are left out: which way they are turned is rounding.
///
/// obstacle   why there are none; else as it was
/// limit      asked at each edge that many faces use, void and solid; null: none
/// left_out   counts the shells that are left out; null: none is
/// throws     Failure when the limit is reached
std::vector<TopoDS_Solid> solids_of(const std::vector<BoundingFace>& faces, std::string& obstacle,
                                    const WorkLimit* limit = nullptr, int* left_out = nullptr);

}  // namespace blossom::occt
