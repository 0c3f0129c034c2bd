// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/meshes/mesh_files.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#ifdef BLOSSOM_WITH_LIB3MF
#include "adapters/lib3mf/three_mf.h"
#endif
#include "adapters/occt/base/errors.h"
#include "adapters/occt/shapes.h"
#include "plugin/meshes/formats/mesh_formats.h"
#include "plugin/meshes/formats/text_words.h"
#include "plugin/meshes/mapped_file.h"
#include "plugin/reports/text/lower_case.h"

namespace blossom::meshes {
namespace {

namespace fs = std::filesystem;

constexpr double kLargest = 1e100;  // of coordinates: volumes of what is larger are no doubles

#ifdef BLOSSOM_WITH_LIB3MF
// "machine:1/Shaft" of "machine:1/Shaft/Face3"; `whole` of "Face3", and before the first group.
std::string part_of(const std::string& group, const std::string& whole) {
  const std::size_t end = group.rfind('/');
  return end == std::string::npos ? whole : group.substr(0, end);
}

// An object for each part that groups are of, or that their names tell. Triangles that repeat a
// corner have no place there.
class ThreeMfObjects {
 public:
  ThreeMfObjects(const FileMesh& mesh, const std::string& name)
      : mesh_(mesh), owner_(mesh.points.size(), 0), number_(mesh.points.size(), 0) {
    std::vector<MeshGroup> groups = mesh.groups;
    if (groups.empty() || groups.front().first > 0) groups.insert(groups.begin(), {name, 0});
    for (std::size_t g = 0; g < groups.size(); ++g)
      pieces_of(groups[g], name)
          .push_back({groups[g].first,
                      g + 1 < groups.size() ? groups[g + 1].first : mesh.triangles.size(),
                      groups[g].colour});
    for (std::size_t k = 0; k < made_.size(); ++k) fill(k);
    std::erase_if(made_, [](const lib3mf::ThreeMfObject& each) { return each.triangles.empty(); });
  }

  const std::vector<lib3mf::ThreeMfObject>& made() const { return made_; }

 private:
  struct Piece {
    std::size_t first, end;
    std::optional<MeshColour> colour;
  };

  std::vector<Piece>& pieces_of(const MeshGroup& group, const std::string& whole) {
    const std::string name = part_of(group.name, whole);
    const auto [place, is_new] =
        places_.try_emplace({group.part, group.part > 0 ? "" : name}, made_.size());
    if (is_new) {
      made_.push_back({name, {}, {}, {}});
      pieces_.emplace_back();
    }
    return pieces_[place->second];
  }

  // All of an object at once, so that one mark a point tells whether it is there.
  void fill(std::size_t object) {
    for (const Piece& piece : pieces_[object]) {
      made_[object].colours.push_back({made_[object].triangles.size(), piece.colour});
      for (std::size_t k = piece.first; k < piece.end; ++k) add(mesh_.triangles[k], object);
    }
  }

  void add(const std::array<int, 3>& triangle, std::size_t object) {
    const auto& [a, b, c] = triangle;
    if (a == b || b == c || c == a) return;
    std::array<int, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = number_of(static_cast<std::size_t>(triangle[k]), object);
    made_[object].triangles.push_back(corners);
  }

  // A point of two parts is one of each.
  int number_of(std::size_t point, std::size_t object) {
    std::vector<Vec3>& points = made_[object].points;
    if (owner_[point] != object + 1) {
      owner_[point] = object + 1;
      number_[point] = static_cast<int>(points.size());
      points.push_back(mesh_.points[point]);
    }
    return number_[point];
  }

  const FileMesh& mesh_;
  std::vector<lib3mf::ThreeMfObject> made_;
  std::vector<std::vector<Piece>> pieces_;                     // of each
  std::map<std::pair<int, std::string>, std::size_t> places_;  // in made_
  std::vector<std::size_t> owner_;  // of a point: 1 + the object filled last that has it, or 0
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

bool is_single(const std::string& ending, bool text) {
  return ending == ".3mf" || (ending == ".stl" && !text);
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
  const std::string ending = reports::lower_ending(file);
  return ending == ".stl" || ending == ".ply" || ending == ".obj" || ending == ".off";
}

bool is_written_mesh_file(const fs::path& file) {
  return is_mesh_file(file) || reports::lower_ending(file) == ".3mf";
}

bool is_glb_file(const fs::path& file) { return reports::lower_ending(file) == ".glb"; }

double writing_bound(const fs::path& file, bool text, double largest) {
  if (!is_single(reports::lower_ending(file), text)) return 0;
  const double half_a_unit = 0.5 * std::numeric_limits<float>::epsilon() * largest;
  return std::sqrt(3.0) * half_a_unit;  // of three coordinates
}

WrittenMesh write_mesh_file(const FileMesh& mesh, const fs::path& file, bool text,
                            const std::function<void()>& stop) {
  const std::string ending = reports::lower_ending(file);
  const bool single = is_single(ending, text);
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
    FileMesh mesh = read_content(MappedFile(file).bytes(), reports::lower_ending(file));
    for (const Vec3& point : mesh.points)
      for (const double x : point.coordinates)
        if (std::abs(x) > kLargest) throw BadContent("has a coordinate beyond 1e+100");
    return mesh;
  } catch (const BadContent& error) {
    throw occt::BadModel(file.string() + ": " + error.what());
  }
}

}  // namespace blossom::meshes
