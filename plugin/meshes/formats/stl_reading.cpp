// SPDX-License-Identifier: LGPL-2.1-or-later
// STL, as text and binary. Many binary files begin with "solid", too: what fits its own count of
// facets is binary, whatever it begins with.
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "core/math/index.h"
#include "plugin/meshes/formats/mesh_formats.h"
#include "plugin/meshes/formats/place_numbers.h"
#include "plugin/meshes/formats/text_scanner.h"

namespace blossom::meshes {
namespace {

constexpr std::size_t kStlHeader = 84;
constexpr std::size_t kStlFacet = 50;
constexpr std::size_t kStlNormal = 12;
constexpr std::size_t kStlCount = 80;     // where the number of facets is
constexpr std::size_t kFirstLook = 4096;  // bytes in which text has a facet

std::uint32_t facets_promised(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kStlCount, sizeof count);  // little-endian
  return count;
}

bool is_text(std::string_view bytes) {
  if (bytes.size() >= kStlHeader &&
      bytes.size() == kStlHeader + kStlFacet * std::uint64_t{facets_promised(bytes)})
    return false;
  TextScanner words(bytes.substr(0, kFirstLook));
  if (words.small_word() != "solid") return false;
  // Text has no bytes that are no characters; a name may be longer than all that is looked at.
  return bytes.substr(0, kFirstLook).find('\0') == std::string_view::npos;
}

FileMesh read_binary(std::string_view bytes) {
  if (bytes.size() < kStlHeader) throw BadContent("is too short for STL");
  const std::uint32_t count = facets_promised(bytes);
  const std::uint64_t room = (bytes.size() - kStlHeader) / kStlFacet;
  if (count > room || (count == 0 && room > 0))
    throw BadContent("its header promises " + std::to_string(count) + " facets, it has room for " +
                     std::to_string(room) + ": it is cut off or no STL file");
  FileMesh mesh;
  mesh.triangles.reserve(count);
  PlaceNumbers places(mesh.points, count / 2);  // a closed mesh has half as many points
  for (std::uint32_t k = 0; k < count; ++k) {
    std::array<float, 9> numbers{};
    std::memcpy(numbers.data(), bytes.data() + kStlHeader + kStlFacet * k + kStlNormal,
                sizeof numbers);
    std::array<int, 3> triangle{};
    for (std::size_t c = 0; c < 3; ++c) {
      Vec3 point;
      for (std::size_t i = 0; i < 3; ++i) {
        point.coordinates[i] = numbers[3 * c + i];
        if (!std::isfinite(numbers[3 * c + i]))
          throw BadContent("facet " + std::to_string(k + 1) +
                           " has a coordinate that is no finite number");
      }
      triangle[c] = places.number(point);
    }
    mesh.triangles.push_back(triangle);
  }
  if (const std::uint64_t left = bytes.size() - kStlHeader - kStlFacet * std::uint64_t{count};
      left > 0)
    mesh.notes.push_back(std::to_string(left) + " bytes after the " + std::to_string(count) +
                         " facets that its header promises were not read");
  return mesh;
}

class TextStl {
 public:
  explicit TextStl(std::string_view bytes) : bytes_(bytes), words_(bytes), places_(mesh_.points) {}

  FileMesh read() {
    bool in_solid = false;
    for (std::string word = words_.small_word(); !word.empty(); word = words_.small_word()) {
      if (word == "solid" && !in_solid) {
        mesh_.groups.push_back({name(), mesh_.triangles.size()});
        in_solid = true;
      } else if (word == "facet" && in_solid) {
        facet();
      } else if ((word == "endsolid" || word == "end") && in_solid) {
        in_solid = false;
        name();
      } else {
        unexpected(word, in_solid ? "facet or endsolid" : "solid");
      }
    }
    if (in_solid) throw BadContent("has no endsolid: it is cut off");
    if (mesh_.groups.size() == 1 && mesh_.groups[0].name.empty()) mesh_.groups.clear();
    std::erase_if(mesh_.groups,
                  [this](const MeshGroup& group) { return group.first == mesh_.triangles.size(); });
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void unexpected(const std::string& word, const std::string& wanted) const {
    if (word.empty()) throw BadContent("ends where " + wanted + " is wanted: it is cut off");
    throw BadContent(words_.place() + "'" + word.substr(0, 40) + "' is there, " + wanted +
                     " is wanted");
  }

  // What follows in the line, but for a facet or a solid that some files have in the same one.
  std::string name() {
    const std::size_t from = words_.offset();
    std::string rest(words_.rest_of_line());
    std::string small = rest;
    for (char& c : small) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    for (const char* const next : {"facet normal", "endsolid", "solid "}) {
      const std::size_t at = small.find(next);
      if (at == std::string::npos || (at > 0 && small[at - 1] != ' ')) continue;
      if (std::string_view(next) == "facet normal" && small.find("outer") == std::string::npos)
        continue;
      words_.move_to(bytes_.find(rest, from) + at);
      rest.resize(at);
      while (!rest.empty() && rest.back() == ' ') rest.pop_back();
      break;
    }
    return rest;
  }

  void expect(const char* wanted) {
    if (const std::string word = words_.small_word(); word != wanted) unexpected(word, wanted);
  }

  // Normals are those of the corners; what a file says of them is often 0 or no number.
  void facet() {
    std::string word = words_.small_word();
    if (word == "normal") {
      for (int k = 0; k < 3; ++k)
        if (words_.word().empty()) unexpected("", "a normal");
      word = words_.small_word();
    }
    if (word != "outer") unexpected(word, "outer");
    expect("loop");
    std::vector<int> corners;
    for (word = words_.small_word(); word == "vertex"; word = words_.small_word())
      corners.push_back(places_.number(words_.point()));
    if (word != "endloop") unexpected(word, "vertex or endloop");
    if (corners.size() < 3)
      throw BadContent(words_.place() + "the facet has " + std::to_string(corners.size()) +
                       " vertices");
    expect("endfacet");
    for (std::size_t k = 2; k < corners.size(); ++k)
      mesh_.triangles.push_back({corners[0], corners[k - 1], corners[k]});
  }

  std::string_view bytes_;
  TextScanner words_;
  FileMesh mesh_;
  PlaceNumbers places_;
};

}  // namespace

FileMesh read_stl(std::string_view bytes) {
  return is_text(bytes) ? TextStl(bytes).read() : read_binary(bytes);
}

}  // namespace blossom::meshes
