// SPDX-License-Identifier: LGPL-2.1-or-later
// Wavefront's .obj, which OpenMesh writes without groups.
#include <algorithm>
#include <cctype>
#include <charconv>

#include "plugin/meshes/mesh_files.h"

namespace blossom::meshes {
namespace {

constexpr std::size_t kLongestNumber = 32;

template <class Number>
void add_number(std::string& text, Number value) {
  std::array<char, kLongestNumber> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  text += ' ';
  text.append(digits.data(), end);
}

// A blank would make two names of it.
std::string one_word(std::string name) {
  std::ranges::replace_if(
      name, [](unsigned char c) { return std::isspace(c) != 0 || std::iscntrl(c) != 0; }, '_');
  return name;
}

}  // namespace

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
