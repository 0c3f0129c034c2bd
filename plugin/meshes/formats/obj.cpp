// SPDX-License-Identifier: LGPL-2.1-or-later
// Wavefront's .obj, with groups.
#include "plugin/meshes/formats/mesh_formats.h"
#include "plugin/meshes/formats/text_words.h"

namespace blossom::meshes {
std::string obj_text(const FileMesh& mesh) {
  std::string text = "# " + std::to_string(mesh.points.size()) + " points, " +
                     std::to_string(mesh.triangles.size()) + " triangles\n";
  for (const Vec3& point : mesh.points) {
    text += 'v';
    for (const double x : point.coordinates) add_number(text, x);
    text += '\n';
  }
  auto group = mesh.groups.begin();
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    for (; group != mesh.groups.end() && group->first == k; ++group)
      text += "g " + one_word(group->name) + '\n';
    text += 'f';
    for (const int corner : mesh.triangles[k]) add_number(text, corner + 1);
    text += '\n';
  }
  return text;
}

}  // namespace blossom::meshes
