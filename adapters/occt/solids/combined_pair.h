// SPDX-License-Identifier: LGPL-2.1-or-later
// Two solids combined: their pieces chosen by side, measured, and put together into solids.

#pragma once

#include <TopTools_MapOfShape.hxx>

#include "adapters/occt/queries/cone_volumes.h"
#include "adapters/occt/solid_trim.h"
#include "core/math/vec.h"

namespace blossom::occt {

/// Where the cones under all faces have their apex when volumes are measured: a vertex of the part,
/// so that the sums keep their digits.
/// throws   BadModel if the part's first face has no vertex
Vec3 cone_apex(const TrimTool& part);

/// What is told of a solid that `are_valid` refuses.
inline constexpr const char* kInvalidSolid = "a solid is not valid by BRepCheck";
/// And of a face of a sheet.
inline constexpr const char* kInvalidFace = "a face is not valid by BRepCheck";

/// One step of `trim_solids`: a part and one tool. Every step measures all three results, whichever
/// is asked for, since only together their volumes can be checked.
///
/// Solids and the faces that are new in them are checked by BRepCheck.
///
/// What stands against one division (solid_divisions.h) may not stand against the next one.
///
/// part, tool   closed solids; the tool may be a sheet, which splits whatever the operation is; or
///              the part is one, of which faces are chosen alone
/// stated       as of SolidDivisions
/// cones        under faces of both and of what is made of them
/// valid        faces that need not be checked, in any orientation
/// returns      volumes of this step; faces as pieces of the part (`tool` is -1) and of the tool
/// (0);
///              what stands against the result in `obstacles`, with Stopped if it is the time limit
/// throws       BadModel if a face cannot be converted
SolidTrimResult combined_pair(const TrimTool& part, const TrimTool& tool, SolidOperation operation,
                              const IntersectionOptions& options, double stated, ConeVolumes& cones,
                              const TopTools_MapOfShape& valid);

}  // namespace blossom::occt
