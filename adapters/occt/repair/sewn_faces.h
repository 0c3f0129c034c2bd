// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces that share no edges, as many files have them, sewn into the solids that they close.

#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <TopoDS_Face.hxx>
#include <TopoDS_Solid.hxx>

#include "core/math/vec.h"

namespace blossom::occt {

struct SewnSolid {
  TopoDS_Solid solid;
  /// Places of its faces among those given, increasing, with what they are in the solid.
  std::vector<std::pair<std::size_t, TopoDS_Face>> faces;
};

struct SewnFaces {
  std::vector<SewnSolid> solids;  ///< in the order of their first faces
  double gap = 0;                 ///< the widest between borders that met, model units
  double within = 0;              ///< within how much borders were joined, model units
  int open_edges = 0;             ///< borders that met none, if others did
  Vec3 open_at;                   ///< the middle of the first
};

/// Sews the faces of each body by Open CASCADE's BRepBuilderAPI_Sewing, within what the gaps
/// between its borders ask for (`border_gaps`). What closes becomes solids; a shell inside of
/// another one is a void of it. A shell that bounds no more than its area times that distance is
/// none.
///
/// within   the widest gap that is one, see `border_gaps`
/// stop     asked often; ends the work by an exception
/// throws   Failure if Open CASCADE fails
SewnFaces sewn_faces(const std::vector<TopoDS_Face>& faces, std::optional<double> within,
                     const std::function<void()>& stop);

}  // namespace blossom::occt
