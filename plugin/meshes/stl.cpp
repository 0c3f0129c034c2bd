// SPDX-License-Identifier: LGPL-2.1-or-later
// STL as text, which OpenMesh writes as one solid without a name.
#include "core/math/index.h"
#include "plugin/meshes/mesh_files.h"
#include "plugin/meshes/text_words.h"

namespace blossom::meshes {
namespace {

void add_vector(std::string& text, const Vec3& v) {
  for (const double x : v.coordinates) add_number(text, x);
  text += '\n';
}

void add_facet(const FileMesh& mesh, const std::array<int, 3>& triangle, std::string& text) {
  const auto corner = [&](std::size_t k) { return mesh.points[index(triangle[k])]; };
  const Vec3 across = cross(corner(1) - corner(0), corner(2) - corner(0));
  const double length = norm(across);
  text += "facet normal";
  add_vector(text, length > 0 ? across * (1 / length) : Vec3{});
  text += "outer loop\n";
  for (std::size_t k = 0; k < 3; ++k) {
    text += "vertex";
    add_vector(text, corner(k));
  }
  text += "endloop\nendfacet\n";
}

}  // namespace

std::string stl_text(const FileMesh& mesh) {
  std::vector<MeshGroup> groups = mesh.groups;
  if (groups.empty() || groups.front().first > 0) groups.insert(groups.begin(), {"mesh", 0});
  std::string text;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const std::size_t end = g + 1 < groups.size() ? groups[g + 1].first : mesh.triangles.size();
    const std::string name = one_word(groups[g].name);
    text += "solid " + name + '\n';
    for (std::size_t k = groups[g].first; k < end; ++k) add_facet(mesh, mesh.triangles[k], text);
    text += "endsolid " + name + '\n';
  }
  return text;
}

}  // namespace blossom::meshes
