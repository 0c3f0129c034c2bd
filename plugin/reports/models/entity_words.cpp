// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/models/entity_words.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <system_error>

namespace blossom::reports {
namespace {

constexpr int kMaxOfRange = 1'000'000;  // so that a slip of the pen does not fill the memory

}  // namespace

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

std::optional<EntityRange> entity_range(std::string_view word, std::string_view kind) {
  const std::size_t dash = word.find('-');
  const std::optional<int> first = entity_number(word.substr(0, dash), kind);
  if (!first) return std::nullopt;
  if (dash == std::string_view::npos) return EntityRange{*first, *first};
  const std::optional<int> last = entity_number(word.substr(dash + 1), kind);
  if (!last || *last < *first || *last - *first >= kMaxOfRange) return std::nullopt;
  return EntityRange{*first, *last};
}

}  // namespace blossom::reports
