// SPDX-License-Identifier: LGPL-2.1-or-later
// Inputs as triangles: files of them, and models.

#pragma once

#include <string>

#include "plugin/meshes/mesh_distance.h"
#include "plugin/meshes/mesh_files.h"

namespace blossom::cli {

/// Whether an input, as the user wrote it, is a file of triangles.
bool is_mesh_input(const std::string& input);

/// The triangles of FILE, or of some of its groups: FILE#Face3, FILE#2,4-6. A stage of its own.
/// throws   UsageError as parse_input; occt::BadModel
meshes::FileMesh read_mesh_input(const std::string& input);

/// Either as triangles.
meshes::MeshSource mesh_source_of(const std::string& input);

}  // namespace blossom::cli
