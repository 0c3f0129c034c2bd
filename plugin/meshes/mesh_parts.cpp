// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/meshes/mesh_parts.h"

#include <algorithm>
#include <numeric>

#include "adapters/occt/base/errors.h"
#include "core/math/index.h"
#include "plugin/meshes/formats/text_words.h"
#include "plugin/reports/text/words.h"

namespace blossom::meshes {
namespace {

constexpr std::size_t kNamedGroups = 5;  // in a message

// What of a group's name, "machine:1/Shaft/Face3", may be written instead of all of it.
enum class NamePart { All, Begin, End };

bool is_called(const std::string& group, const std::string& name, NamePart part) {
  if (part == NamePart::All) return group == name;
  return part == NamePart::Begin ? group.starts_with(name + '/') : group.ends_with('/' + name);
}

std::string quoted(const std::string& name) { return "'" + name + "'"; }

// Of different names, the first few.
std::vector<std::string> quoted_names(const std::vector<MeshGroup>& groups,
                                      const std::vector<std::size_t>& places) {
  std::vector<std::string> names;
  for (const std::size_t place : places) {
    const std::string name = quoted(groups[place].name);
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    if (names.size() == kNamedGroups) break;
  }
  return names;
}

[[noreturn]] void refuse_name(const std::vector<MeshGroup>& groups, const std::string& name,
                              const std::string& file) {
  std::vector<std::size_t> all(groups.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const std::vector<std::string> names = quoted_names(groups, all);
  std::string text = file + ": there is no group " + quoted(name);
  if (names.empty()) throw occt::BadModel(text + ", it has none");
  text += (names.size() == 1 ? "; there is " : "; there are ") + reports::listed(names, "and");
  throw occt::BadModel(text + (groups.size() > names.size() ? "; info --faces lists all" : ""));
}

// All that are called so; of the end of a name they have to be of one.
std::vector<std::size_t> groups_called(const std::vector<MeshGroup>& groups,
                                       const std::string& name, const std::string& file) {
  for (const NamePart part : {NamePart::All, NamePart::Begin, NamePart::End}) {
    std::vector<std::size_t> found;
    for (std::size_t g = 0; g < groups.size(); ++g)
      if (is_called(groups[g].name, name, part) || is_called(groups[g].name, one_word(name), part))
        found.push_back(g);
    const std::vector<std::string> names = quoted_names(groups, found);
    if (part == NamePart::End && names.size() > 1)
      throw occt::BadModel(file + ": " + quoted(name) + " may be " + reports::listed(names));
    if (!found.empty()) return found;
  }
  refuse_name(groups, name, file);
}

}  // namespace

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
  for (const int number : numbers) {
    if (number < 1 || index(number) > mesh.groups.size())
      throw occt::BadModel(file + ": there is no group " + std::to_string(number) + "; it has " +
                           std::to_string(mesh.groups.size()));
    wanted[index(number) - 1] = true;
  }
  for (const std::string& name : names)
    for (const std::size_t g : groups_called(mesh.groups, name, file)) wanted[g] = true;
  std::vector<std::size_t> places;
  for (std::size_t g = 0; g < mesh.groups.size(); ++g) {
    const std::size_t end =
        g + 1 < mesh.groups.size() ? mesh.groups[g + 1].first : mesh.triangles.size();
    for (std::size_t k = mesh.groups[g].first; wanted[g] && k < end; ++k) places.push_back(k);
  }
  return chosen_triangles(mesh, places);
}

}  // namespace blossom::meshes
