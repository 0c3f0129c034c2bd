// SPDX-License-Identifier: LGPL-2.1-or-later
// Files of triangles: .stl, .ply, .obj and .off; .3mf is written, too.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/math/vec.h"

namespace blossom::meshes {

/// Red, green and blue, as files have them.
using MeshColour = std::array<std::uint8_t, 3>;

/// Triangles from a place on, up to the next group, that belong together.
struct MeshGroup {
  std::string name;
  std::size_t first = 0;
  std::optional<MeshColour> colour{};
  int part = 0;  ///< of the model that it was made of, from 1; 0 if at most the name tells

  bool operator==(const MeshGroup&) const = default;
};

struct FileMesh {
  std::vector<Vec3> points;                   ///< model units
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise from outside
  std::vector<MeshGroup> groups{};            ///< in order; all but binary .stl and .off keep them
  std::vector<std::string> notes{};           ///< what of a file that was read is not here
};

/// .stl, .ply, .obj or .off in any case.
bool is_mesh_file(const std::filesystem::path& file);

/// Those, or .3mf, which is written only.
bool is_written_mesh_file(const std::filesystem::path& file);

/// .glb in any case.
bool is_glb_file(const std::filesystem::path& file);

struct WrittenMesh {
  double rounding = 0;  ///< how far single precision moves points, model units; binary .stl and
                        ///< .3mf have it
  std::vector<std::string> lost{};  ///< of "names" and "colours" of groups, what has no place there
};

/// How far writing a file may move points whose coordinates are no larger, model units: a bound on
/// the rounding to single precision; 0 where the format keeps doubles.
double writing_bound(const std::filesystem::path& file, bool text, double largest);

/// Binary where the format has that (.stl, .ply), unless `text`; whole or not at all. All but
/// binary .stl give the same doubles back, and the groups; .ply and .off their colours, too.
///
/// stop     see occt::write_text
/// throws   occt::Failure if it cannot be written; occt::BadModel if lib3mf was not built in
WrittenMesh write_mesh_file(const FileMesh& mesh, const std::filesystem::path& file, bool text,
                            const std::function<void()>& stop);

/// Reads any kind of a format, told by the content: text with blanks, line ends and cases of any
/// kind, binary of either byte order. Polygons become triangles; points of .stl that are
/// equal become one. Nothing is repaired, nothing left out without a note: triangles may repeat
/// corners, and sides may have more than two of them.
///
/// throws   occt::BadModel, with the line or the facet, if the file is missing, empty, cut off,
///          promises more than it holds, has numbers that are none, not finite or beyond 1e100, a
///          face names a vertex that is not there, or there is no triangle. Memory stays in
///          proportion to the file's size
FileMesh read_mesh_file(const std::filesystem::path& file);

/// The content of an .obj file: a `g` line before each group, blanks in its name as underscores.
/// Numbers read back as the same doubles.
std::string obj_text(const FileMesh& mesh);

/// Likewise that of an .stl file as text: a solid for each group, with its name.
std::string stl_text(const FileMesh& mesh);

}  // namespace blossom::meshes
