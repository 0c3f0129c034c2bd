// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/meshes/formats/mesh_formats.h"
#include "plugin/meshes/formats/text_words.h"

namespace blossom::meshes {

std::string off_text(const FileMesh& mesh) {
  const bool coloured = has_colours(mesh);
  std::string text = "OFF\n" + std::to_string(mesh.points.size()) + " " +
                     std::to_string(mesh.triangles.size()) + " 0\n";
  for (const Vec3& point : mesh.points) {
    const std::size_t before = text.size();
    for (const double x : point.coordinates) add_number(text, x);
    text.erase(before, 1);  // the blank in front
    text += '\n';
  }
  std::size_t next = 0;
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    while (next < mesh.groups.size() && mesh.groups[next].first <= k) ++next;
    text += '3';
    for (const int corner : mesh.triangles[k]) add_number(text, corner);
    if (coloured)
      for (const std::uint8_t part : colour_or_grey(mesh, next))
        add_number(text, static_cast<int>(part));
    text += '\n';
  }
  for (const MeshGroup& group : mesh.groups)
    text += "# group " + std::to_string(group.first) + " " + one_line(group.name) + "\n";
  return text;
}

}  // namespace blossom::meshes
