// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/meshes/mesh_files.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <string_view>
#include <system_error>

#ifdef BLOSSOM_WITH_LIB3MF
#include "adapters/lib3mf/three_mf.h"
#endif
#include "adapters/occt/base/errors.h"
#include "adapters/occt/shapes.h"
#include "plugin/meshes/formats/mesh_formats.h"
#include "plugin/meshes/formats/text_words.h"

namespace blossom::meshes {
namespace {

namespace fs = std::filesystem;

std::string small_ending(const fs::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

#ifdef BLOSSOM_WITH_LIB3MF
// Triangles that repeat a corner have no place there.
std::string three_mf(const FileMesh& mesh, const std::string& name) {
  std::vector<std::array<int, 3>> triangles;
  std::vector<lib3mf::ThreeMfPart> parts;
  std::size_t next = 0;
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    for (; next < mesh.groups.size() && mesh.groups[next].first <= k; ++next)
      parts.push_back({triangles.size(), mesh.groups[next].colour});
    const auto& [a, b, c] = mesh.triangles[k];
    if (a != b && b != c && c != a) triangles.push_back(mesh.triangles[k]);
  }
  try {
    return lib3mf::three_mf_bytes(name, mesh.points, triangles, parts);
  } catch (const lib3mf::ThreeMfFailure& error) {
    throw occt::Failure(error.what());
  }
}
#else
std::string three_mf(const FileMesh&, const std::string& name) {
  throw occt::BadModel(name + ".3mf: for this format lib3mf was not built in");
}
#endif

std::vector<std::string> lost_of(const FileMesh& mesh, const std::string& ending, bool single) {
  std::vector<std::string> lost;
  if (single && !mesh.groups.empty()) lost.push_back("names");
  if ((ending == ".stl" || ending == ".obj") && has_colours(mesh)) lost.push_back("colours");
  return lost;
}

double rounding_of(const std::vector<Vec3>& points) {
  double most = 0;
  for (const Vec3& p : points) {
    Vec3 off;
    for (int k = 0; k < 3; ++k) off[k] = static_cast<double>(static_cast<float>(p[k])) - p[k];
    most = std::max(most, norm(off));
  }
  return most;
}

std::string content_of(const fs::path& file) {
  std::error_code error;
  const std::uint64_t size = fs::file_size(file, error);
  std::ifstream stream(file, std::ios::binary);
  if (error || !stream) throw BadContent("there is no such file, or it cannot be read");
  if (size == 0) throw BadContent("the file is empty");
  std::string bytes(size, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(size));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

FileMesh read_content(std::string_view bytes, const std::string& ending) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (bytes.starts_with(kByteOrderMark)) bytes.remove_prefix(kByteOrderMark.size());
  FileMesh mesh = ending == ".stl"   ? read_stl(bytes)
                  : ending == ".ply" ? read_ply(bytes)
                  : ending == ".off" ? read_off(bytes)
                  : ending == ".obj" ? read_obj(bytes)
                                     : throw BadContent("is no mesh by its ending");
  if (mesh.triangles.empty()) throw BadContent("there is no triangle in it");
  return mesh;
}

}  // namespace

bool is_mesh_file(const fs::path& file) {
  const std::string ending = small_ending(file);
  return ending == ".stl" || ending == ".ply" || ending == ".obj" || ending == ".off";
}

bool is_written_mesh_file(const fs::path& file) {
  return is_mesh_file(file) || small_ending(file) == ".3mf";
}

bool is_glb_file(const fs::path& file) { return small_ending(file) == ".glb"; }

WrittenMesh write_mesh_file(const FileMesh& mesh, const fs::path& file, bool text,
                            const std::function<void()>& stop) {
  const std::string ending = small_ending(file);
  const bool single = ending == ".3mf" || (ending == ".stl" && !text);
  occt::write_text(ending == ".obj"   ? obj_text(mesh)
                   : ending == ".off" ? off_text(mesh)
                   : ending == ".ply" ? ply_content(mesh, text)
                   : ending == ".3mf" ? three_mf(mesh, file.stem().string())
                   : single           ? stl_bytes(mesh)
                                      : stl_text(mesh),
                   file, stop);
  return {single ? rounding_of(mesh.points) : 0, lost_of(mesh, ending, single)};
}

FileMesh read_mesh_file(const fs::path& file) {
  try {
    return read_content(content_of(file), small_ending(file));
  } catch (const BadContent& error) {
    throw occt::BadModel(file.string() + ": " + error.what());
  }
}

}  // namespace blossom::meshes
