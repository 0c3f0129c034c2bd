// SPDX-License-Identifier: LGPL-2.1-or-later
// Whether solids that were put together are valid by BRepCheck.

#pragma once

#include <vector>

#include <TopTools_MapOfShape.hxx>
#include <TopoDS_Solid.hxx>

#include "adapters/occt/solid_trim.h"
#include "core/base/work_limit.h"

namespace blossom::occt {

/// What `BRepCheck_Analyzer` says of the solid, its shells and all faces but the known ones: those,
/// with all that bounds them, are as they were given, and most of them a cut never reaches.
///
/// known   faces of inputs, in any orientation
bool is_valid(const TopoDS_Solid& solid, const TopTools_MapOfShape& known);

/// Of all solids.
/// limit    asked before each
/// throws   Failure when the limit is reached
bool are_valid(const std::vector<TopoDS_Solid>& solids, const TopTools_MapOfShape& known,
               const WorkLimit& limit);

/// Whether a new face is a sliver that its edges' tolerances cover: `is_covered` in
/// core/topology/face_trims.h.
///
/// known   as of are_valid
bool has_covered_face(const std::vector<TopoDS_Solid>& solids, const TopTools_MapOfShape& known);

/// Lets vertices cover the places beside them in which edges that leave them in one direction cross
/// in the parameters of a face, as BRepCheck sees them: if up to there the edges come no farther
/// from each other than their tolerances and their ends say. What touches with a radius r keeps
/// within t for sqrt(8 r t).
///
/// known     as of are_valid
/// returns   whether a vertex is wider now
bool cover_tangent_corners(const std::vector<TopoDS_Solid>& solids,
                           const TopTools_MapOfShape& known);

/// Of faces that bound no solid, all but the known ones.
bool are_valid(const std::vector<SolidFace>& faces, const TopTools_MapOfShape& known);

}  // namespace blossom::occt
