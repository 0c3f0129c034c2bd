// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/meshes/mesh_files.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <map>
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
// "machine:1/Shaft" of "machine:1/Shaft/Face3"; `whole` of "Face3", and before the first group.
std::string part_of(const std::string& group, const std::string& whole) {
  const std::size_t end = group.rfind('/');
  return end == std::string::npos ? whole : group.substr(0, end);
}

// An object for each part that groups are named by. Triangles that repeat a corner have no place
// there.
class ThreeMfObjects {
 public:
  ThreeMfObjects(const FileMesh& mesh, const std::string& name)
      : mesh_(mesh), owner_(mesh.points.size(), 0), number_(mesh.points.size(), 0) {
    std::size_t next = 0;
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
      for (; next < mesh.groups.size() && mesh.groups[next].first <= k; ++next) {
        enter(part_of(mesh.groups[next].name, name));
        current().colours.push_back({current().triangles.size(), mesh.groups[next].colour});
      }
      if (made_.empty()) enter(name);
      add(mesh.triangles[k]);
    }
    std::erase_if(made_, [](const lib3mf::ThreeMfObject& each) { return each.triangles.empty(); });
  }

  const std::vector<lib3mf::ThreeMfObject>& made() const { return made_; }

 private:
  lib3mf::ThreeMfObject& current() { return made_[current_]; }

  void enter(const std::string& name) {
    const auto [place, is_new] = places_.try_emplace(name, made_.size());
    current_ = place->second;
    if (is_new) made_.push_back({name, {}, {}, {}});
  }

  void add(const std::array<int, 3>& triangle) {
    const auto& [a, b, c] = triangle;
    if (a == b || b == c || c == a) return;
    std::array<int, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = number_of(static_cast<std::size_t>(triangle[k]));
    current().triangles.push_back(corners);
  }

  // A point of two parts is one of each.
  int number_of(std::size_t point) {
    if (owner_[point] != current_ + 1) {
      owner_[point] = current_ + 1;
      number_[point] = static_cast<int>(current().points.size());
      current().points.push_back(mesh_.points[point]);
    }
    return number_[point];
  }

  const FileMesh& mesh_;
  std::vector<lib3mf::ThreeMfObject> made_;
  std::map<std::string, std::size_t> places_;  // in made_, by name
  std::size_t current_ = 0;
  std::vector<std::size_t> owner_;  // of a point: 1 + the object that had it last; 0 if none
  std::vector<int> number_;         // in that object
};

std::string three_mf(const FileMesh& mesh, const std::string& name) {
  try {
    return lib3mf::three_mf_bytes(ThreeMfObjects(mesh, name).made());
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
