// SPDX-License-Identifier: LGPL-2.1-or-later
// The content of files of triangles, by format. For this folder and its tests.

#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "plugin/meshes/mesh_files.h"

namespace blossom::meshes {

/// Why content cannot be used, without the file's name.
class BadContent : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Each throws BadContent as read_mesh_file says.
FileMesh read_stl(std::string_view bytes);
FileMesh read_ply(std::string_view bytes);
FileMesh read_obj(std::string_view bytes);
FileMesh read_off(std::string_view bytes);

/// Coordinates in single precision, normals of facets, no groups.
std::string stl_bytes(const FileMesh& mesh);

/// Little-endian unless `text`. Of each face a number `group`, and `red`, `green`, `blue` if any
/// group has a colour; the names are in comments of the header, `group NUMBER NAME`.
std::string ply_content(const FileMesh& mesh, bool text);

/// With colours of faces; groups are told in comments at the end, `# group FIRST NAME`.
std::string off_text(const FileMesh& mesh);

}  // namespace blossom::meshes
