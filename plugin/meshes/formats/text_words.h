// SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers, names and colours in mesh files. For this folder only.

#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <string>

#include "plugin/meshes/mesh_files.h"

namespace blossom::meshes {

/// A blank and the shortest text that reads back as the same number.
template <class Number>
void add_number(std::string& text, Number value) {
  constexpr std::size_t kLongestNumber = 32;
  std::array<char, kLongestNumber> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  text += ' ';
  text.append(digits.data(), end);
}

/// A name without blanks, which would make two of it.
inline std::string one_word(std::string name) {
  std::ranges::replace_if(
      name, [](unsigned char c) { return std::isspace(c) != 0 || std::iscntrl(c) != 0; }, '_');
  return name;
}

/// A name without line ends.
inline std::string one_line(std::string name) {
  std::ranges::replace_if(
      name, [](unsigned char c) { return std::iscntrl(c) != 0; }, '_');
  return name;
}

inline bool has_colours(const FileMesh& mesh) {
  return std::ranges::any_of(mesh.groups, [](const MeshGroup& g) { return g.colour.has_value(); });
}

/// What triangles without a colour get beside others that have one.
inline constexpr MeshColour kNoColour{204, 204, 204};

/// next   the number of the group after the triangle's
inline MeshColour colour_or_grey(const FileMesh& mesh, std::size_t next) {
  return next > 0 ? mesh.groups[next - 1].colour.value_or(kNoColour) : kNoColour;
}

}  // namespace blossom::meshes
