// SPDX-License-Identifier: LGPL-2.1-or-later
// STL: as text a solid for each group, in binary without groups.
#include <array>
#include <cstdint>

#include "core/math/index.h"
#include "plugin/meshes/formats/little_endian.h"
#include "plugin/meshes/formats/mesh_formats.h"
#include "plugin/meshes/formats/text_words.h"

namespace blossom::meshes {
namespace {

void add_vector(std::string& text, const Vec3& v) {
  for (const double x : v.coordinates) add_number(text, x);
  text += '\n';
}

// 0 of a triangle without area.
Vec3 unit_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 across = cross(b - a, c - a);
  const double length = norm(across);
  return length > 0 ? across * (1 / length) : Vec3{};
}

void add_facet(const FileMesh& mesh, const std::array<int, 3>& triangle, std::string& text) {
  const auto corner = [&](std::size_t k) { return mesh.points[index(triangle[k])]; };
  text += "facet normal";
  add_vector(text, unit_normal(corner(0), corner(1), corner(2)));
  text += "outer loop\n";
  for (std::size_t k = 0; k < 3; ++k) {
    text += "vertex";
    add_vector(text, corner(k));
  }
  text += "endloop\nendfacet\n";
}

void add_floats(const Vec3& v, std::string& bytes) {
  for (const double x : v.coordinates) add_bytes(bytes, static_cast<float>(x));
}

}  // namespace

std::string stl_bytes(const FileMesh& mesh) {
  constexpr std::size_t kHeader = 80;
  constexpr std::size_t kFacet = 50;
  std::string bytes = "binary STL";  // and never "solid", which text begins with
  bytes.resize(kHeader, ' ');
  bytes.reserve(kHeader + 4 + kFacet * mesh.triangles.size());
  add_bytes(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    const auto corner = [&](std::size_t k) { return mesh.points[index(triangle[k])]; };
    add_floats(unit_normal(corner(0), corner(1), corner(2)), bytes);
    for (std::size_t k = 0; k < 3; ++k) add_floats(corner(k), bytes);
    add_bytes(bytes, std::uint16_t{0});
  }
  return bytes;
}

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
