// SPDX-License-Identifier: LGPL-2.1-or-later
// What is wrong with triangles. It takes CGAL.

#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/meshes/mesh_facts.h"
#include "plugin/meshes/mesh_files.h"
#include "plugin/reports/text/json.h"

namespace blossom::meshes {

/// What is wrong with triangles, see adapters/cgal/mesh_judge.h.
struct JudgedMesh : MeshFacts {
  std::size_t degenerate = 0;
  std::size_t crossings = 0;
  std::size_t repeated = 0;                          ///< of `crossings`
  std::vector<std::array<int, 2>> crossing_pairs{};  ///< the first of them

  bool sound() const {
    return closed() && crowded_sides == 0 && degenerate == 0 && crossings == 0 && volume > 0;
  }
};

/// Nothing if it was built without CGAL.
/// stop       asked now and then; may throw to end the work
/// crossing   called for each pair of triangles that cross
std::optional<JudgedMesh> judged_mesh(const FileMesh& mesh, const std::function<void()>& stop,
                                      const std::function<void(int, int)>& crossing = {});

/// Schema blossom.mesh-check/1.
reports::Json mesh_check_report(const std::string& file, const FileMesh& mesh,
                                const JudgedMesh& found);

/// The same in lines.
std::string mesh_check_text(const std::string& file, const FileMesh& mesh, const JudgedMesh& found);

/// Notes of a file that was read, a line each.
std::string notes_text(const FileMesh& mesh);

}  // namespace blossom::meshes
