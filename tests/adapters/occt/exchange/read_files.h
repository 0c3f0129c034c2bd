// SPDX-License-Identifier: LGPL-2.1-or-later
// Files that are damaged on purpose, and what reading says of them.

#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace blossom::testing {

/// What reading says, without the file's name, which must stand before it.
std::string refusal(const std::filesystem::path& file);

/// The first loss of a file that is read in parts.
std::string loss(const std::filesystem::path& file);

int faces_of(const std::filesystem::path& file);

/// A small good file of a format, as text: the machine of `write_machine`.
std::string sample(const std::string& ending);

/// The text with `to` for the first `from`, which must be in it.
std::string replaced(std::string text, const std::string& from, const std::string& to);

/// Text in UTF-16 or UTF-32: so many bytes a letter, the least first or last.
std::string wide(const std::string& text, std::size_t bytes, bool least_first, bool mark);

}  // namespace blossom::testing
