// SPDX-License-Identifier: LGPL-2.1-or-later

#include "core/math/index.h"
#include "plugin/meshes/formats/little_endian.h"
#include "plugin/meshes/formats/mesh_formats.h"
#include "plugin/meshes/formats/text_words.h"

namespace blossom::meshes {
namespace {

std::string header_of(const FileMesh& mesh, bool text, bool coloured) {
  std::string header =
      std::string("ply\nformat ") + (text ? "ascii" : "binary_little_endian") + " 1.0\n";
  for (std::size_t g = 0; g < mesh.groups.size(); ++g)
    header += "comment group " + std::to_string(g) + " " + one_line(mesh.groups[g].name) + "\n";
  header += "element vertex " + std::to_string(mesh.points.size()) +
            "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
            std::to_string(mesh.triangles.size()) + "\nproperty list uchar int vertex_indices\n";
  if (!mesh.groups.empty()) header += "property int group\n";
  if (coloured) header += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  return header + "end_header\n";
}

class PlyWriter {
 public:
  PlyWriter(std::string& bytes, bool text) : bytes_(bytes), text_(text) {}

  void add(double value) {
    if (text_)
      add_word(value);
    else
      add_bytes(bytes_, value);
  }
  void add(int value) {
    if (text_)
      add_word(value);
    else
      add_bytes(bytes_, static_cast<std::int32_t>(value));
  }
  void add(std::uint8_t value) {
    if (text_)
      add_word(static_cast<int>(value));
    else
      add_bytes(bytes_, value);
  }
  void end() {
    if (text_) bytes_ += '\n';
    begun_ = false;
  }

 private:
  template <class Number>
  void add_word(Number value) {
    const std::size_t before = bytes_.size();
    add_number(bytes_, value);
    if (!begun_) bytes_.erase(before, 1);  // the blank in front
    begun_ = true;
  }

  std::string& bytes_;
  bool text_, begun_ = false;
};

}  // namespace

std::string ply_content(const FileMesh& mesh, bool text) {
  const bool coloured = has_colours(mesh);
  std::string bytes = header_of(mesh, text, coloured);
  if (!text) {
    const std::size_t triangle = 1 + 3 * sizeof(std::int32_t) + 3 * coloured +
                                 (mesh.groups.empty() ? 0 : sizeof(std::int32_t));
    bytes.reserve(bytes.size() + 3 * sizeof(double) * mesh.points.size() +
                  triangle * mesh.triangles.size());
  }
  PlyWriter writer(bytes, text);
  for (const Vec3& point : mesh.points) {
    for (const double x : point.coordinates) writer.add(x);
    writer.end();
  }
  std::size_t next = 0;
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    while (next < mesh.groups.size() && mesh.groups[next].first <= k) ++next;
    writer.add(static_cast<std::uint8_t>(3));
    for (const int corner : mesh.triangles[k]) writer.add(corner);
    if (!mesh.groups.empty()) writer.add(static_cast<int>(next) - 1);
    if (coloured)
      for (const std::uint8_t part : colour_or_grey(mesh, next)) writer.add(part);
    writer.end();
  }
  return bytes;
}

}  // namespace blossom::meshes
