// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/mesh_curves.h"

#include <utility>

#ifdef BLOSSOM_WITH_CGAL
#include "adapters/cgal/mesh_intersection.h"
#endif
#include "plugin/cli/exit_code.h"
#include "plugin/cli/interruption.h"

namespace blossom::cli {

#ifdef BLOSSOM_WITH_CGAL
namespace {

MeshCurves told(cgal::MeshMeeting found) {
  MeshCurves made{.curves = {},
                  .points = std::move(found.points),
                  .rounding = found.rounding,
                  .touching = found.touching,
                  .in_plane = found.in_plane,
                  .flat = found.flat};
  for (cgal::MeshCurve& curve : found.curves)
    made.curves.push_back({std::move(curve.points), curve.closed, curve.length});
  return made;
}

cgal::MeshView view(const meshes::FileMesh& mesh) { return {mesh.points, mesh.triangles}; }

}  // namespace

MeshCurves curves_of_meshes(const meshes::FileMesh& a, const meshes::FileMesh& b) {
  return told(cgal::intersect_meshes(view(a), view(b), stop_if_interrupted));
}

MeshCurves curves_in_plane(const meshes::FileMesh& mesh, const occt::Plane& plane) {
  return told(cgal::section_of_mesh(view(mesh), plane.point, plane.normal, stop_if_interrupted));
}
#else
MeshCurves curves_of_meshes(const meshes::FileMesh&, const meshes::FileMesh&) {
  throw UsageError("intersections of triangles need CGAL, which this program lacks");
}

MeshCurves curves_in_plane(const meshes::FileMesh&, const occt::Plane&) {
  throw UsageError("sections of triangles need CGAL, which this program lacks");
}
#endif

}  // namespace blossom::cli
