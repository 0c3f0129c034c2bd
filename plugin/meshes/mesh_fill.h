// SPDX-License-Identifier: LGPL-2.1-or-later
// A mesh with its holes filled, and what is told of it.

#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "plugin/meshes/mesh_files.h"
#include "plugin/meshes/mesh_judge.h"
#include "plugin/reports/text/json.h"

namespace blossom::meshes {

struct FilledMesh {
  FileMesh mesh;  ///< with a group "fill" behind all others
  struct Hole {
    std::vector<std::size_t> sides;  ///< of its rings
    std::size_t triangles = 0;
    bool flat = false;
  };
  std::vector<Hole> holes;
  std::size_t left_sides = 0;          ///< open ones that go round no hole
  std::optional<JudgedMesh> judged{};  ///< the result; nothing without CGAL
  double seconds = 0;

  /// Whether all open sides are gone.
  bool whole() const { return left_sides == 0; }
};

/// See core/meshes/mesh_holes.h. Points at equal places count as one, which is noted.
/// stop     asked now and then; may throw to end the work
FilledMesh with_holes_filled(FileMesh mesh, const std::function<void()>& stop);

/// The mesh with one of each of its points; a note says how many others there were.
FileMesh with_points_joined(FileMesh mesh);

/// Schema blossom.mesh-fill/1.
reports::Json mesh_fill_report(const std::string& file, const FilledMesh& filled);
std::string mesh_fill_text(const std::string& file, const FilledMesh& filled);

}  // namespace blossom::meshes
