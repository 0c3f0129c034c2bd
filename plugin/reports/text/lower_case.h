// SPDX-License-Identifier: LGPL-2.1-or-later
// Words and endings of files, whose case does not matter.

#pragma once

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

namespace blossom::reports {

/// With its ASCII letters in lower case.
inline std::string lower_case(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// ".stl" of "PART.STL".
inline std::string lower_ending(const std::filesystem::path& file) {
  return lower_case(file.extension().string());
}

}  // namespace blossom::reports
