// SPDX-License-Identifier: LGPL-2.1-or-later
// Where triangles meet others, and planes. It takes CGAL; a program that is built without it says
// so.

#pragma once

#include <cstddef>
#include <vector>

#include "adapters/occt/plane_section.h"
#include "plugin/meshes/mesh_files.h"

namespace blossom::cli {

struct MeshPolyline {
  std::vector<Vec3> points;  ///< the first again at the end of a closed one
  bool closed = false;
  double length = 0;
};

/// See adapters/cgal/mesh_intersection.h.
struct MeshCurves {
  std::vector<MeshPolyline> curves;
  std::vector<Vec3> points;
  double rounding = 0;
  bool touching = false;
  std::size_t in_plane = 0, flat = 0;
};

/// It may be interrupted.
/// throws   UsageError if the program has no CGAL; InvalidInput
MeshCurves curves_of_meshes(const meshes::FileMesh& a, const meshes::FileMesh& b);
MeshCurves curves_in_plane(const meshes::FileMesh& mesh, const occt::Plane& plane);

}  // namespace blossom::cli
