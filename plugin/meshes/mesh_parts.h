// SPDX-License-Identifier: LGPL-2.1-or-later
// Groups of a mesh.

#pragma once

#include <string>
#include <vector>

#include "plugin/meshes/mesh_files.h"

namespace blossom::meshes {

/// Some groups of a mesh, with the points that they have.
///
/// numbers   from 1 on, in the order of the file
/// names     of groups, also with blanks as underscores: all that are called so; else those of a
///           part, "Shaft" of "Shaft/Face3"; else the end of one name, "Face3"
/// throws    occt::BadModel, with `file`, if there is no such group, or the end of several names
FileMesh chosen_groups(const FileMesh& mesh, const std::vector<int>& numbers,
                       const std::vector<std::string>& names, const std::string& file);

/// The triangles of these places, with the points and groups that they have.
FileMesh chosen_triangles(const FileMesh& mesh, const std::vector<std::size_t>& places);

}  // namespace blossom::meshes
