// SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers and names in mesh files of text. For this folder only.

#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <string>

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

}  // namespace blossom::meshes
