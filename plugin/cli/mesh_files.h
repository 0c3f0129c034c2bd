// SPDX-License-Identifier: LGPL-2.1-or-later
// Files of triangles. They take OpenMesh, and what is wrong with triangles takes CGAL; a program
// that is built without them says so.

#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/math/vec.h"

namespace blossom::cli {

struct FileMesh {
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;
};

/// .stl, .ply, .obj or .off in any case.
bool is_mesh_file(const std::filesystem::path& file);

/// .glb in any case.
bool is_glb_file(const std::filesystem::path& file);

struct WrittenMesh {
  double rounding = 0;  ///< how far single precision moves points, model units
  int apart = 0;        ///< triangles that got vertices of their own
};

/// Binary unless `text`, or the format is text always; whole or not at all.
/// throws   UsageError if the program has no OpenMesh; occt::Failure if it cannot be written
WrittenMesh write_mesh_file(const FileMesh& mesh, const std::string& file, bool text);

/// throws   UsageError likewise; occt::BadModel if the mesh cannot be used
FileMesh read_mesh_file(const std::filesystem::path& file);

/// What is wrong with triangles, see adapters/cgal/mesh_judge.h.
struct JudgedMesh {
  std::size_t open_sides = 0, crowded_sides = 0, turned_sides = 0;
  std::size_t degenerate = 0, parts = 0, crossings = 0;
  double area = 0, volume = 0;
  std::vector<std::array<int, 2>> crossing_pairs;

  bool closed() const { return open_sides == 0 && crowded_sides == 0 && turned_sides == 0; }
};

/// Nothing if the program has no CGAL. It may be interrupted.
std::optional<JudgedMesh> judged_mesh(const FileMesh& mesh);

}  // namespace blossom::cli
