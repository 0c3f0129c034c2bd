// SPDX-License-Identifier: LGPL-2.1-or-later
// Files of triangles: .stl, .ply, .obj and .off.

#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/math/vec.h"

namespace blossom::meshes {

/// Triangles from a place on, up to the next group, that belong together.
struct MeshGroup {
  std::string name;
  std::size_t first = 0;
};

struct FileMesh {
  std::vector<Vec3> points;                   ///< model units
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise from outside
  std::vector<MeshGroup> groups{};            ///< in order; in .obj, and in .stl as text
};

/// .stl, .ply, .obj or .off in any case.
bool is_mesh_file(const std::filesystem::path& file);

/// .glb in any case.
bool is_glb_file(const std::filesystem::path& file);

struct WrittenMesh {
  double rounding = 0;  ///< how far single precision moves points, model units; .obj and
                        ///< .stl as text have double
  int apart = 0;        ///< triangles that got vertices of their own
};

/// Binary unless `text`, or the format is text always; whole or not at all.
/// stop     see occt::write_text
/// throws   occt::BadModel if there is no OpenMesh for the format; occt::Failure if it cannot be
///          written
WrittenMesh write_mesh_file(const FileMesh& mesh, const std::filesystem::path& file, bool text,
                            const std::function<void()>& stop);

/// throws   occt::BadModel likewise, or if the mesh cannot be used
FileMesh read_mesh_file(const std::filesystem::path& file);

/// The content of an .obj file: a `g` line before each group, blanks in its name as underscores.
/// Numbers read back as the same doubles.
std::string obj_text(const FileMesh& mesh);

/// Likewise that of an .stl file as text: a solid for each group, with its name.
std::string stl_text(const FileMesh& mesh);

}  // namespace blossom::meshes
