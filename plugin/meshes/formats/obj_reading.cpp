// SPDX-License-Identifier: LGPL-2.1-or-later
// Wavefront's .obj: vertices, polygons, groups.
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string>
#include <vector>

#include "plugin/meshes/formats/mesh_formats.h"
#include "plugin/meshes/formats/text_scanner.h"
#include "plugin/meshes/mesh_polygons.h"

namespace blossom::meshes {
namespace {

class ObjReader {
 public:
  // text   with continued lines joined
  explicit ObjReader(std::string_view text)
      : words_(text, '#'), polygons_(mesh_, [this] { return words_.place(); }) {}

  FileMesh read() {
    for (auto word = words_.word(); !word.empty(); word = words_.word()) {
      if (word == "v")
        mesh_.points.push_back(words_.point());
      else if (word == "f" || word == "fo")
        polygon();
      else if (word == "g" || word == "o")
        group(word == "g");
      else if (word == "l" || word == "p" || word == "surf" || word == "curv")
        ++others_;
      // What else there is tells how it looks; it has no place in triangles.
      words_.rest_of_line();
    }
    std::erase_if(mesh_.groups,
                  [this](const MeshGroup& one) { return one.first == mesh_.triangles.size(); });
    if (others_ > 0)
      mesh_.notes.push_back(std::to_string(others_) +
                            " lines, points, curves and surfaces of the file are no polygons and "
                            "were left out");
    return std::move(mesh_);
  }

 private:
  // Objects are groups where there are no others.
  void group(bool is_group) {
    if (!is_group && has_groups_) return;
    has_groups_ = has_groups_ || is_group;
    std::string name(words_.rest_of_line());
    if (!mesh_.groups.empty() && mesh_.groups.back().first == mesh_.triangles.size())
      mesh_.groups.back().name = std::move(name);
    else
      mesh_.groups.push_back({std::move(name), mesh_.triangles.size()});
  }

  // Corners as VERTEX/TEXTURE/NORMAL, of which the first counts; negative from the end.
  void polygon() {
    corners_.clear();
    for (auto word = words_.word_of_line(); !word.empty(); word = words_.word_of_line()) {
      std::int64_t number = 0;
      const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
      if (error != std::errc() || (end != word.data() + word.size() && *end != '/'))
        throw BadContent(words_.place() + "'" + std::string(word.substr(0, 40)) +
                         "' is no corner of a face");
      const auto count = static_cast<std::int64_t>(mesh_.points.size());
      corners_.push_back(number < 0 ? count + number : number - 1);
    }
    polygons_.add(corners_);
  }

  TextScanner words_;
  FileMesh mesh_;
  Polygons polygons_;
  std::vector<std::int64_t> corners_;
  std::size_t others_ = 0;
  bool has_groups_ = false;
};

// A backslash at the end of a line continues it.
std::string joined_lines(std::string_view bytes) {
  std::string text(bytes);
  for (std::size_t at = text.find('\\'); at != std::string::npos; at = text.find('\\', at + 1)) {
    const std::size_t next = at + 1 < text.size() && text[at + 1] == '\r' ? at + 2 : at + 1;
    if (next >= text.size() || (text[next] != '\n' && next == at + 1)) continue;
    std::fill(text.begin() + static_cast<std::ptrdiff_t>(at),
              text.begin() + static_cast<std::ptrdiff_t>(
                                 std::min(text.size(), text[next] == '\n' ? next + 1 : next)),
              ' ');
  }
  return text;
}

}  // namespace

FileMesh read_obj(std::string_view bytes) {
  if (bytes.find('\\') == std::string_view::npos) return ObjReader(bytes).read();
  return ObjReader(joined_lines(bytes)).read();
}

}  // namespace blossom::meshes
