// SPDX-License-Identifier: LGPL-2.1-or-later
// Where triangles meet others, and planes. It takes CGAL.

#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "adapters/occt/plane_section.h"
#include "core/base/status.h"
#include "plugin/meshes/mesh_files.h"
#include "plugin/reports/text/json.h"

namespace blossom::meshes {

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

/// Nothing if it was built without CGAL.
/// stop     asked now and then; may throw to end the work
/// throws   InvalidInput
std::optional<MeshCurves> curves_of_meshes(const FileMesh& a, const FileMesh& b,
                                           const std::function<void()>& stop);
std::optional<MeshCurves> curves_in_plane(const FileMesh& mesh, const occt::Plane& plane,
                                          const std::function<void()>& stop);

/// As a section, which has writers: each polyline a curve of degree 1.
occt::PlaneSection section_of(const MeshCurves& found);

/// "touching", "in_plane", "curves", "points".
reports::Json curves_json(const MeshCurves& found);

/// What two meshes have in common.
struct MeshPair {
  std::string a, b;     ///< names
  double within_a = 0;  ///< how far triangles may be from what they stand for
  double within_b = 0;
  MeshCurves found{};
  double seconds = 0;

  // Of models curves may be missing, or meet in another way, where they nearly touch.
  Status status() const {
    return found.touching || within_a + within_b > 0 ? Status::Tolerance : Status::Complete;
  }
};

/// Schema blossom.mesh-intersection/1.
reports::Json mesh_pair_report(const MeshPair& pair);

struct PlaneOfMesh {
  std::string name;
  occt::Plane plane;
  std::optional<double> offset{};
  MeshCurves found{};
};

/// Schema blossom.mesh-sections/1.
reports::Json mesh_sections_report(const std::string& file, Status status,
                                   const std::vector<PlaneOfMesh>& planes, double seconds);

/// "2 polylines (1 open) of length 20, 1 point".
std::string counted_curves(const MeshCurves& found);

}  // namespace blossom::meshes
