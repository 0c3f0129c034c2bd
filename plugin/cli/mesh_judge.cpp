// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/mesh_judge.h"

#include <utility>

#ifdef BLOSSOM_WITH_CGAL
#include "adapters/cgal/mesh_judge.h"
#endif
#include "plugin/cli/interruption.h"

namespace blossom::cli {

#ifdef BLOSSOM_WITH_CGAL
std::optional<JudgedMesh> judged_mesh(const FileMesh& mesh) {
  cgal::MeshVerdict found = cgal::judge_mesh(mesh.points, mesh.triangles, stop_if_interrupted);
  return JudgedMesh{found.open_sides, found.crowded_sides, found.turned_sides,
                    found.degenerate, found.parts,         found.crossings,
                    found.area,       found.volume,        std::move(found.crossing_pairs)};
}
#else
std::optional<JudgedMesh> judged_mesh(const FileMesh&) { return {}; }
#endif

}  // namespace blossom::cli
