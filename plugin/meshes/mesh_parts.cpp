// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/meshes/mesh_parts.h"

#include "adapters/occt/base/errors.h"
#include "core/math/index.h"
#include "plugin/meshes/formats/text_words.h"

namespace blossom::meshes {

FileMesh chosen_triangles(const FileMesh& mesh, const std::vector<std::size_t>& places) {
  FileMesh part;
  part.notes = mesh.notes;
  std::vector<int> number(mesh.points.size(), -1);
  std::size_t next = 0, last = 0;  // groups before the triangle, and before the one before
  for (const std::size_t place : places) {
    while (next < mesh.groups.size() && mesh.groups[next].first <= place) ++next;
    if (next > last) {
      part.groups.push_back(mesh.groups[next - 1]);
      part.groups.back().first = part.triangles.size();
      last = next;
    }
    std::array<int, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      int& of = number[index(mesh.triangles[place][k])];
      if (of < 0) {
        of = static_cast<int>(part.points.size());
        part.points.push_back(mesh.points[index(mesh.triangles[place][k])]);
      }
      triangle[k] = of;
    }
    part.triangles.push_back(triangle);
  }
  return part;
}

FileMesh chosen_groups(const FileMesh& mesh, const std::vector<int>& numbers,
                       const std::vector<std::string>& names, const std::string& file) {
  std::vector<bool> wanted(mesh.groups.size(), false);
  const auto refuse = [&](const std::string& what) {
    throw occt::BadModel(file + ": there is no group " + what + "; it has " +
                         std::to_string(mesh.groups.size()));
  };
  for (const int number : numbers) {
    if (number < 1 || index(number) > mesh.groups.size()) refuse(std::to_string(number));
    wanted[index(number) - 1] = true;
  }
  for (const std::string& name : names) {
    bool any = false;
    for (std::size_t g = 0; g < mesh.groups.size(); ++g)
      if (mesh.groups[g].name == name || mesh.groups[g].name == one_word(name))
        wanted[g] = any = true;
    if (!any) refuse("'" + name + "'");
  }
  std::vector<std::size_t> places;
  for (std::size_t g = 0; g < mesh.groups.size(); ++g) {
    const std::size_t end =
        g + 1 < mesh.groups.size() ? mesh.groups[g + 1].first : mesh.triangles.size();
    for (std::size_t k = mesh.groups[g].first; wanted[g] && k < end; ++k) places.push_back(k);
  }
  return chosen_triangles(mesh, places);
}

}  // namespace blossom::meshes
