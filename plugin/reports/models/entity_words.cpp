// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/models/entity_words.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <system_error>

namespace blossom::reports {

std::optional<int> entity_number(std::string_view word, std::string_view kind) {
  const auto same = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; };
  if (word.size() > kind.size() && std::equal(kind.begin(), kind.end(), word.begin(),
                                              [&](char b, char a) { return same(a, b); })) {
    word.remove_prefix(kind.size());
    if (word.starts_with(':')) word.remove_prefix(1);
  }
  int number = 0;
  const char* const end = word.data() + word.size();
  const auto read = std::from_chars(word.data(), end, number);
  if (read.ec != std::errc{} || read.ptr != end || number < 1) return std::nullopt;
  return number;
}

}  // namespace blossom::reports
