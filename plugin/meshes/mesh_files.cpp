// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/meshes/mesh_files.h"

#include <algorithm>
#include <cctype>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/shapes.h"
#ifdef BLOSSOM_WITH_OPENMESH
#include "adapters/openmesh/triangles.h"
#endif

namespace blossom::meshes {
namespace {

std::string small_ending(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

#ifndef BLOSSOM_WITH_OPENMESH
[[noreturn]] void refuse(const std::filesystem::path& file) {
  throw occt::BadModel(file.string() + ": is of triangles, for which OpenMesh was not built in");
}
#endif

}  // namespace

bool is_mesh_file(const std::filesystem::path& file) {
  const std::string ending = small_ending(file);
  return ending == ".stl" || ending == ".ply" || ending == ".obj" || ending == ".off";
}

bool is_glb_file(const std::filesystem::path& file) { return small_ending(file) == ".glb"; }

WrittenMesh write_mesh_file(const FileMesh& mesh, const std::filesystem::path& file, bool text,
                            const std::function<void()>& stop) {
  const std::string ending = small_ending(file);
  if (ending == ".obj" || (ending == ".stl" && text)) {
    occt::write_text(ending == ".obj" ? obj_text(mesh) : stl_text(mesh), file, stop);
    return {};
  }
#ifdef BLOSSOM_WITH_OPENMESH
  const openmesh::MeshBytes made =
      openmesh::mesh_bytes({mesh.points, mesh.triangles}, ending,
                           text ? openmesh::Encoding::Text : openmesh::Encoding::Binary);
  occt::write_text(made.bytes, file, stop);
  return {made.rounding, made.apart};
#else
  static_cast<void>(text);
  refuse(file);
#endif
}

FileMesh read_mesh_file(const std::filesystem::path& file) {
#ifdef BLOSSOM_WITH_OPENMESH
  try {
    openmesh::TriangleSoup read = openmesh::read_triangles(file);
    return {std::move(read.points), std::move(read.triangles)};
  } catch (const openmesh::BadMesh& error) {
    throw occt::BadModel(error.what());
  }
#else
  refuse(file);
#endif
}

}  // namespace blossom::meshes
