// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangles of a model that cross, by the faces and parts that they are of.

#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "plugin/meshes/mesh_files.h"
#include "plugin/meshes/mesh_judge.h"
#include "plugin/reports/models/input.h"

namespace blossom::meshes {

/// By the number of a face - 1 the part that it is of, as clash counts them from 1 on; 0 of faces
/// that the input does not name.
std::vector<int> parts_of_faces(const reports::Input& input);

/// Pairs of triangles that cross. What parts do to each other is none of their faults.
struct Crossings {
  using Faces = std::set<std::array<int, 2>>;  ///< pairs of numbers, the lesser one first

  std::size_t inside = 0, between = 0;   ///< of parts
  Faces faces{}, faces_inside{};         ///< all, and those of one part
  std::map<int, std::size_t> of_face{};  ///< of `inside`, by the number of each face
};

struct JudgedParts {
  JudgedMesh mesh;
  Crossings crossings{};
};

/// Nothing without CGAL.
/// number_of   of the face of a triangle, by the triangle's place
/// stop        asked now and then; may throw to end the work
std::optional<JudgedParts> judged_parts(const FileMesh& mesh, const std::vector<int>& number_of,
                                        const std::vector<int>& parts,
                                        const std::function<void()>& stop);

}  // namespace blossom::meshes
