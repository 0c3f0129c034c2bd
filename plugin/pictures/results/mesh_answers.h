// SPDX-License-Identifier: LGPL-2.1-or-later
// What was found of triangles as pictures.

#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "plugin/meshes/mesh_curves.h"
#include "plugin/meshes/mesh_distance.h"
#include "plugin/meshes/mesh_fill.h"
#include "plugin/meshes/mesh_judge.h"
#include "plugin/pictures/scene/picture.h"

namespace blossom::pictures {

/// Triangles that cross others, and faulty sides.
/// stop   throws what ends the work; here and below
Picture mesh_check_picture(const std::string& input, const meshes::FileMesh& mesh,
                           const meshes::JudgedMesh& found, const std::function<void()>& stop);

Picture mesh_pair_picture(const meshes::MeshPair& pair,
                          const std::array<const meshes::MeshSource*, 2>& inputs,
                          const std::function<void()>& stop);

Picture mesh_sections_picture(const std::string& input, const meshes::FileMesh& mesh,
                              const std::vector<meshes::PlaneOfMesh>& planes,
                              const std::function<void()>& stop);

/// What fills holes in a colour of its own.
Picture mesh_fill_picture(const std::string& input, const meshes::FilledMesh& filled,
                          const std::function<void()>& stop);

}  // namespace blossom::pictures
