// SPDX-License-Identifier: LGPL-2.1-or-later
// A file of triangles is read: .stl, .ply, .obj or .off, as the first byte says.
#include <cmath>

#include "adapters/occt/base/errors.h"
#include "plugin/meshes/mesh_files.h"
#include "tests/fuzz/support/files.h"

namespace blossom::fuzz {

void try_input(Bytes input) try {
  constexpr const char* kEndings[] = {".stl", ".ply", ".obj", ".off"};
  if (input.empty()) return;
  const meshes::FileMesh mesh =
      meshes::read_mesh_file(file_of(input.subspan(1), kEndings[input.front() % 4]));
  const auto count = static_cast<int>(mesh.points.size());
  for (const auto& triangle : mesh.triangles)
    for (const int corner : triangle)
      require(0 <= corner && corner < count, "a triangle has a corner that is not there");
  for (const Vec3& point : mesh.points)
    require(std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]),
            "a point is not finite");
  require(!meshes::obj_text(mesh).empty(), "triangles are written as nothing");
  meshes::stl_text(mesh);
} catch (const occt::BadModel&) {
}

}  // namespace blossom::fuzz
