// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces and their control nets as polygon meshes, written to files by OpenMesh.

#pragma once

#include <filesystem>
#include <stdexcept>
#include <vector>

#include "core/forms/patch.h"
#include "core/forms/surface.h"
#include "core/math/vec.h"

namespace blossom::openmesh {

/// The mesh cannot be written. The message names the file and the cause.
class WriteFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Polygons, counter-clockwise round the normal S_u x S_v of the surface they came from.
struct Mesh {
  std::vector<Vec3> points;             ///< model units
  std::vector<std::vector<int>> faces;  ///< indices of points
};

/// Triangles on a surface: each point of the surface is within `tolerance` of the point with the
/// same parameters on its triangle, to which the surface's own error adds.
///
/// Patches share the points of their common borders, and a closed direction joins its last row
/// to its first. Triangles of no area, as at the pole of a sphere, are left out.
///
/// tolerance   model units, positive
/// throws      InvalidInput if the surface is not well formed or has no patch, the tolerance is
///             not positive and finite, or it is too small (see cells_for_tolerance)
Mesh tessellation(const BezierSurface& surface, double tolerance);
Mesh tessellation(const RationalBezierPatch& patch, double tolerance);
Mesh tessellation(const BezierPatch& patch, double tolerance);

/// The control points in space, with a quadrilateral for each four neighbours of a patch's net.
/// Nets of neighbouring patches are not joined.
Mesh control_net(const BezierSurface& surface);
Mesh control_net(const RationalBezierPatch& patch);
Mesh control_net(const BezierPatch& patch);

/// Writes a mesh as .obj, .off, .ply or .stl (any case), in text. OpenMesh writes coordinates in
/// single precision there, so each is rounded to 24 bits. In .stl, which has triangles only,
/// polygons are cut into fans. What was there before stays when writing fails.
///
/// throws      WriteFailure if the ending is another, the file cannot be written, or an edge would
///             belong to more than two polygons
void write_mesh(const Mesh& mesh, const std::filesystem::path& file);

}  // namespace blossom::openmesh
