// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/mesh_files.h"

#include <algorithm>
#include <cctype>

#ifdef BLOSSOM_WITH_CGAL
#include "adapters/cgal/mesh_judge.h"
#endif
#include "adapters/occt/base/errors.h"
#include "adapters/occt/shapes.h"
#ifdef BLOSSOM_WITH_OPENMESH
#include "adapters/openmesh/triangles.h"
#endif
#include "plugin/cli/exit_code.h"
#include "plugin/cli/interruption.h"
#include "plugin/cli/options.h"

namespace blossom::cli {
namespace {

#ifndef BLOSSOM_WITH_OPENMESH
[[noreturn]] void refuse(const std::filesystem::path& file) {
  throw UsageError(file.string() + ": is of triangles, for which this program lacks OpenMesh");
}
#endif

}  // namespace

bool is_mesh_file(const std::filesystem::path& file) {
  const std::string ending = ending_of(file.string());
  return ending == ".stl" || ending == ".ply" || ending == ".obj" || ending == ".off";
}

bool is_glb_file(const std::filesystem::path& file) { return ending_of(file.string()) == ".glb"; }

#ifdef BLOSSOM_WITH_OPENMESH
WrittenMesh write_mesh_file(const FileMesh& mesh, const std::string& file, bool text) {
  const openmesh::MeshBytes made =
      openmesh::mesh_bytes({mesh.points, mesh.triangles}, ending_of(file),
                           text ? openmesh::Encoding::Text : openmesh::Encoding::Binary);
  occt::write_text(made.bytes, file, stop_if_interrupted);
  return {made.rounding, made.apart};
}

FileMesh read_mesh_file(const std::filesystem::path& file) {
  try {
    openmesh::TriangleSoup read = openmesh::read_triangles(file);
    return {std::move(read.points), std::move(read.triangles)};
  } catch (const openmesh::BadMesh& error) {
    throw occt::BadModel(error.what());
  }
}
#else
WrittenMesh write_mesh_file(const FileMesh&, const std::string& file, bool) { refuse(file); }

FileMesh read_mesh_file(const std::filesystem::path& file) { refuse(file); }
#endif

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
