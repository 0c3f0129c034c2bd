// SPDX-License-Identifier: LGPL-2.1-or-later
// Places in a STEP text, beside its strings and comments. For this folder only.

#pragma once

#include <cstddef>
#include <string_view>

#include "adapters/occt/exchange/file_text.h"

namespace blossom::occt {

inline constexpr std::size_t kNowhere = std::string_view::npos;

/// Whether a word in capitals stands at a place, in either case.
bool has_word(std::string_view text, std::size_t place, std::string_view word);

/// The place behind a string, a binary or a comment that begins at a place: the place itself if
/// none does, the end of the text if it is not closed.
std::size_t behind_quoted(std::string_view text, std::size_t place);

/// The place behind blanks and comments.
std::size_t behind_blanks(std::string_view text, std::size_t place);

/// The place of the first semicolon that is in no string; nowhere if there is none.
std::size_t semicolon_from(std::string_view text, std::size_t place);

inline bool is_digit(char c) { return '0' <= c && c <= '9'; }

/// A number without the zeros before it.
std::string_view without_zeros(std::string_view digits);

/// Calls `take(number, behind)` for each "#12=" that a text has, in strings and comments, too: with
/// the digits, without zeros before them, and the place behind it and the blanks that follow.
template <class Take>
void for_each_head(std::string_view text, const Take& take) {
  for (std::size_t sign = text.find('='); sign != kNowhere; sign = text.find('=', sign + 1)) {
    std::size_t end = sign;
    while (end > 0 && is_blank(text[end - 1])) --end;
    std::size_t begin = end;
    while (begin > 0 && is_digit(text[begin - 1])) --begin;
    if (begin > 0 && begin < end && text[begin - 1] == '#')
      take(without_zeros(text.substr(begin, end - begin)), behind_blanks(text, sign + 1));
  }
}

}  // namespace blossom::occt
