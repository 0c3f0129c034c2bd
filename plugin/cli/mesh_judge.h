// SPDX-License-Identifier: LGPL-2.1-or-later
// What is wrong with triangles. It takes CGAL; a program that is built without it says so.

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "plugin/meshes/mesh_files.h"

namespace blossom::cli {

using meshes::FileMesh;

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
