// SPDX-License-Identifier: LGPL-2.1-or-later
// Hatches of faces, and of parts of them.

#pragma once

#include <vector>

#include <TopoDS_Face.hxx>

#include "core/math/vec.h"

namespace blossom::pictures {

/// Lines on the surface of a face, within closed polygons in its parameters.
///
/// They are straight in the parameters, at about 45 degrees to both directions and about `spacing`
/// apart (model units), where the surface is stretched evenly.
///
/// polygons  a point is inside if a ray from it meets their sides an odd number of times
std::vector<std::vector<Vec3>> hatch_lines(const TopoDS_Face& face,
                                           const std::vector<std::vector<Vec2>>& polygons,
                                           double spacing);

/// The wires of a face as such polygons.
std::vector<std::vector<Vec2>> wire_polygons(const TopoDS_Face& face);

}  // namespace blossom::pictures
