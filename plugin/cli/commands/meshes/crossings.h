// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangles of a model that cross, by the faces and parts that they are of.

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <vector>

#include "plugin/cli/arguments/inputs.h"
#include "plugin/meshes/mesh_judge.h"

namespace blossom::cli {

/// By the number of a face - 1 the part that it is of, as clash counts them from 1 on; 0 of faces
/// that the input does not name.
std::vector<int> parts_of_faces(const Input& input);

/// Pairs of triangles that cross. What parts do to each other is none of their faults.
struct Crossings {
  using Faces = std::set<std::array<int, 2>>;  ///< pairs of numbers, the lesser one first

  std::size_t inside = 0, between = 0;  ///< of parts
  Faces faces{}, faces_inside{};        ///< all, and those of one part
};

struct JudgedParts {
  meshes::JudgedMesh mesh;
  Crossings crossings{};
};

/// Nothing without CGAL.
/// number_of   of the face of a triangle, by the triangle's place
/// throws      at an interruption
std::optional<JudgedParts> judged_parts(const meshes::FileMesh& mesh,
                                        const std::vector<int>& number_of,
                                        const std::vector<int>& parts);

}  // namespace blossom::cli
