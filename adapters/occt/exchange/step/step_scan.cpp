// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/exchange/step/step_scan.h"

#include <algorithm>
#include <cctype>

namespace blossom::occt {

bool has_word(std::string_view text, std::size_t place, std::string_view word) {
  if (place > text.size() || text.size() - place < word.size()) return false;
  return std::equal(
      word.begin(), word.end(), text.begin() + static_cast<std::ptrdiff_t>(place),
      [](char capital, char c) { return capital == std::toupper(static_cast<unsigned char>(c)); });
}

std::size_t behind_quoted(std::string_view text, std::size_t place) {
  const char first = text[place];
  std::size_t end = place;
  if (first == '\'' || first == '"')
    end = text.find(first, place + 1);
  else if (first == '/' && text.substr(place, 2) == "/*")
    end = text.find("*/", place + 2);
  else
    return place;
  return end == kNowhere ? text.size() : end + (first == '/' ? 2 : 1);
}

std::size_t behind_blanks(std::string_view text, std::size_t place) {
  while (place < text.size()) {
    if (is_blank(text[place])) {
      ++place;
    } else if (const std::size_t behind = behind_quoted(text, place);
               text[place] == '/' && behind > place) {
      place = behind;
    } else {
      break;
    }
  }
  return place;
}

std::size_t semicolon_from(std::string_view text, std::size_t place) {
  while (place < text.size() && text[place] != ';') {
    const std::size_t behind = behind_quoted(text, place);
    place = behind > place ? behind : place + 1;
  }
  return place < text.size() ? place : kNowhere;
}

std::string_view without_zeros(std::string_view digits) {
  while (digits.size() > 1 && digits.front() == '0') digits.remove_prefix(1);
  return digits;
}

}  // namespace blossom::occt
