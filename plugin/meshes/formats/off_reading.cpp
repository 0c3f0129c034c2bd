// SPDX-License-Identifier: LGPL-2.1-or-later
// Geomview's OFF: as text, and binary of either byte order.
#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "plugin/meshes/formats/mesh_formats.h"
#include "plugin/meshes/formats/text_scanner.h"
#include "plugin/meshes/formats/text_words.h"
#include "plugin/meshes/mesh_polygons.h"

namespace blossom::meshes {
namespace {

// Bytes that a vertex and a face take at least as text, with what parts them.
constexpr std::uint64_t kMinTextVertex = 6;
constexpr std::uint64_t kMinTextFace = 4;

// What "OFF" may have in front: texture coordinates, colours, normals of each vertex, a fourth
// coordinate, a dimension.
struct OffKind {
  int extra = 0;  // numbers after a vertex's place; -1: as many as the line has
  bool binary = false;
};

OffKind kind_of(std::string header, std::string_view rest) {
  OffKind kind;
  const std::size_t at = header.find("off");
  if (at == std::string::npos || at + 3 != header.size() || header.find_first_not_of("stcn") < at)
    throw BadContent(header.find("off") == std::string::npos
                         ? "has no header of OFF"
                         : "is OFF of the kind " + header + ", which is not read");
  kind.extra = at > 0 ? -1 : 0;
  kind.binary = rest == "BINARY";
  return kind;
}

// Comments `# group FIRST NAME`, as off_text writes them.
void read_groups(std::string_view bytes, FileMesh& mesh) {
  constexpr std::string_view kMark = "# group ";
  for (std::size_t at = bytes.find(kMark); at != std::string_view::npos;
       at = bytes.find(kMark, at)) {
    TextScanner line(bytes.substr(at += kMark.size()));
    const std::string_view number = line.word_of_line();
    std::size_t first = 0;
    const auto read = std::from_chars(number.data(), number.data() + number.size(), first);
    const bool in_order = mesh.groups.empty() ? first == 0 : first > mesh.groups.back().first;
    if (read.ec != std::errc() || !in_order || first >= mesh.triangles.size()) continue;
    mesh.groups.push_back({std::string(line.rest_of_line()), first});
  }
}

// Of a face: 3 or 4 numbers, of which whole ones run to 255 and others to 1; or one, which names a
// colour of another file.
std::optional<MeshColour> colour_of(TextScanner& words) {
  std::vector<std::string_view> found;
  for (auto word = words.word_of_line(); !word.empty(); word = words.word_of_line())
    found.push_back(word);
  if (found.size() < 3) return {};
  MeshColour colour{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double value = number_of(found[k], "a colour: ");
    const bool is_part = found[k].find('.') != std::string_view::npos;
    colour[k] = static_cast<std::uint8_t>(
        std::lround(std::clamp(is_part ? value * 255 : value, 0.0, 255.0)));
  }
  return colour;
}

FileMesh read_text(std::string_view bytes, TextScanner words, OffKind kind) {
  const std::int64_t vertices = words.whole(), faces = words.whole();
  words.whole();  // of edges, which is not kept
  refuse_large(bytes.size(), vertices, kMinTextVertex, faces, kMinTextFace);
  FileMesh mesh;
  for (std::int64_t k = 0; k < vertices; ++k) {
    mesh.points.push_back(words.point());
    if (kind.extra < 0)
      while (!words.word_of_line().empty()) {
      }
  }
  Polygons polygons(mesh, [&words] { return words.place(); });
  std::vector<std::int64_t> corners;
  for (std::int64_t k = 0; k < faces; ++k) {
    corners.clear();
    for (std::int64_t left = words.whole(); left > 0; --left) corners.push_back(words.whole());
    polygons.add(corners);
    polygons.colour(colour_of(words));
  }
  polygons.make_groups_of_colours();
  std::vector<MeshGroup> coloured = std::exchange(mesh.groups, {});
  read_groups(bytes, mesh);
  if (mesh.groups.empty())
    mesh.groups = std::move(coloured);
  else
    for (MeshGroup& group : mesh.groups)
      for (const MeshGroup& one : coloured)
        if (one.first <= group.first)
          group.colour = one.colour == kNoColour ? std::nullopt : one.colour;
  return mesh;
}

// ---- binary

class BinaryOff {
 public:
  BinaryOff(std::string_view bytes, std::endian order)
      : bytes_(bytes), swap_(order != std::endian::native) {}

  // Nothing if counts and content do not fit each other in this order of bytes.
  std::optional<FileMesh> read() {
    const std::uint32_t vertices = whole(), faces = whole();
    whole();
    if (ended_ || vertices > bytes_.size() / 12 || faces > bytes_.size() / 16) return {};
    FileMesh mesh;
    for (std::uint32_t k = 0; k < vertices && !ended_; ++k) {
      Vec3 point;
      for (double& x : point.coordinates) x = std::bit_cast<float>(whole());
      mesh.points.push_back(point);
    }
    std::uint32_t k = 0;
    Polygons polygons(mesh, [&k] { return "face " + std::to_string(k + 1) + ": "; });
    for (; k < faces && !ended_; ++k) {
      const std::uint32_t count = whole();
      if (count > bytes_.size() / 4) return {};
      std::vector<std::int64_t> corners(count);
      for (std::int64_t& corner : corners) corner = whole();
      // Their colour's count and floats; of OpenMesh's files, which have none, not even a 0.
      polygons.add(corners);
      if (has_colours_)
        for (std::uint32_t left = std::min<std::uint32_t>(whole(), 4); left > 0; --left) whole();
    }
    if (ended_ || at_ != bytes_.size()) return {};
    return mesh;
  }

  void expect_colours() { has_colours_ = true; }

 private:
  std::uint32_t whole() {
    if (bytes_.size() - at_ < sizeof(std::uint32_t)) {
      ended_ = true;
      return 0;
    }
    std::array<char, sizeof(std::uint32_t)> raw{};
    std::memcpy(raw.data(), bytes_.data() + at_, raw.size());
    if (swap_) std::ranges::reverse(raw);
    at_ += raw.size();
    return std::bit_cast<std::uint32_t>(raw);
  }

  std::string_view bytes_;
  std::size_t at_ = 0;
  bool swap_, ended_ = false, has_colours_ = false;
};

FileMesh read_binary_off(std::string_view bytes) {
  for (const bool colours : {true, false})
    for (const std::endian order : {std::endian::big, std::endian::little}) {
      BinaryOff reader(bytes, order);
      if (colours) reader.expect_colours();
      try {
        if (auto mesh = reader.read()) return std::move(*mesh);
      } catch (const BadContent&) {
        continue;  // the other order may fit
      }
    }
  throw BadContent("is binary, and its content does not fit its counts: it is cut off or damaged");
}

}  // namespace

FileMesh read_off(std::string_view bytes) {
  TextScanner words(bytes, '#');
  const std::string header = words.small_word();
  if (!header.empty() && std::isdigit(static_cast<unsigned char>(header[0]))) {
    words.move_to(0);  // the format lets files begin with their counts
    return read_text(bytes, words, {});
  }
  const std::size_t after = words.offset();
  const std::string_view next = words.word_of_line();
  const OffKind kind = kind_of(header, next);
  if (kind.binary) {
    const std::size_t end = bytes.find('\n', after);
    return read_binary_off(end == std::string_view::npos ? "" : bytes.substr(end + 1));
  }
  words.move_to(after);
  return read_text(bytes, words, kind);
}

}  // namespace blossom::meshes
