// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangles to and from the bytes of mesh files, by OpenMesh's writers and readers.

#pragma once

#include <array>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/math/vec.h"

namespace blossom::openmesh {

/// Triangles as they come, of which more than two may share a side.
struct TriangleSoup {
  std::vector<Vec3> points;                   ///< model units
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise from outside
};

enum class Encoding { Binary, Text };

/// ".stl", ".ply", ".obj" or ".off", in lower case.
bool is_mesh_ending(const std::string& ending);

struct MeshBytes {
  std::string bytes;
  /// Formats have single precision: how far points are moved by it. Model units.
  double rounding = 0;
  /// Triangles that got vertices of their own, since OpenMesh's half-edges are of manifolds alone:
  /// where more than two share a side, or triangles touch at a vertex only.
  int apart = 0;
};

/// The content of a file.
///
/// ending     see is_mesh_ending; .obj is text always
/// throws     std::invalid_argument if the ending is another
/// cost       O(n)
MeshBytes mesh_bytes(const TriangleSoup& mesh, const std::string& ending, Encoding encoding);

/// The mesh in a file cannot be used. The message names the file and the cause.
class BadMesh : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads .stl, .ply, .obj or .off, binary or in text. Polygons become fans of triangles; points of
/// .stl that are equal become one. Nothing is repaired and nothing left out: triangles may repeat
/// corners.
///
/// throws     BadMesh if the file is missing, empty, cut off, promises more than it holds, has
///            numbers that are none, or no triangle. Memory stays in proportion to the file's size.
TriangleSoup read_triangles(const std::filesystem::path& file);

}  // namespace blossom::openmesh
