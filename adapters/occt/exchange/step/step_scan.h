// SPDX-License-Identifier: LGPL-2.1-or-later
// Places in a STEP text, beside its strings and comments. For this folder only.

#pragma once

#include <cstddef>
#include <string_view>

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

}  // namespace blossom::occt
