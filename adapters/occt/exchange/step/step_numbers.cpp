// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/exchange/step/step_numbers.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "adapters/occt/exchange/file_text.h"
#include "adapters/occt/exchange/step/step_scan.h"

namespace blossom::occt {
namespace {

/// Calls `take(begin, end)` with the digits of each "#12" outside of strings and comments.
template <class Take>
void for_each_number(std::string_view text, const Take& take) {
  for (std::size_t place = 0; place < text.size();) {
    if (const std::size_t behind = behind_quoted(text, place); behind > place) {
      place = behind;
      continue;
    }
    const bool sign = text[place] == '#';
    std::size_t end = ++place;
    while (sign && end < text.size() && is_digit(text[end])) ++end;
    if (end > place) take(place, end);
    place = end;
  }
}

bool is_large(std::string_view digits) {
  static const std::string kLargest = std::to_string(std::numeric_limits<int>::max());
  return digits.size() > kLargest.size() || (digits.size() == kLargest.size() && digits > kLargest);
}

bool has_large_numbers(std::string_view text) {
  bool large = false;
  for_each_head(text,
                [&](std::string_view number, std::size_t) { large = large || is_large(number); });
  return large;
}

/// Whether the number of an entity, or what seems to be one in a string, repeats.
bool may_repeat(std::string_view text) {
  std::vector<std::string_view> all;
  for_each_head(text, [&](std::string_view number, std::size_t) { all.push_back(number); });
  const auto before = [](std::string_view a, std::string_view b) {
    return a.size() != b.size() ? a.size() < b.size() : a < b;
  };
  if (!std::ranges::is_sorted(all, before)) std::ranges::sort(all, before);
  return std::ranges::adjacent_find(all) != all.end();
}

std::string without_blanks(std::string_view text) {
  std::string shorter;
  std::ranges::copy_if(text, std::back_inserter(shorter), [](char c) { return !is_blank(c); });
  return shorter;
}

}  // namespace

void drop_repeated_entities(std::string& text, ReadingReport& report) {
  if (!may_repeat(text)) return;
  std::unordered_map<std::string_view, std::string> first;
  for_each_number(text, [&](std::size_t begin, std::size_t end) {
    const std::size_t sign = behind_blanks(text, end);
    if (sign >= text.size() || text[sign] != '=') return;
    const std::size_t last = std::min(semicolon_from(text, sign), text.size() - 1);
    const std::string_view number =
        without_zeros(std::string_view(text).substr(begin, end - begin));
    const std::string_view entity = std::string_view(text).substr(sign, last - sign);
    const auto [known, is_new] = first.try_emplace(number, without_blanks(entity));
    if (is_new) return;
    if (known->second != without_blanks(entity))
      report.add({"entity number",
                  "several entities have it, and the first is taken",
                  true,
                  1,
                  {"#" + std::string(number)}});
    std::fill(text.begin() + static_cast<std::ptrdiff_t>(begin - 1),
              text.begin() + static_cast<std::ptrdiff_t>(last + 1), ' ');
  });
}

void renumber_large_entities(std::string& text) {
  if (!has_large_numbers(text)) return;
  std::unordered_map<std::string_view, std::size_t> numbers;
  std::string renumbered;
  std::size_t done = 0;
  for_each_number(text, [&](std::size_t begin, std::size_t end) {
    const auto [found, is_new] = numbers.try_emplace(
        without_zeros(std::string_view(text).substr(begin, end - begin)), numbers.size() + 1);
    renumbered.append(text, done, begin - done).append(std::to_string(found->second));
    done = end;
  });
  renumbered.append(text, done);
  text = std::move(renumbered);
}

}  // namespace blossom::occt
