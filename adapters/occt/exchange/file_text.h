// SPDX-License-Identifier: LGPL-2.1-or-later
// What is in a model file: its bytes, unpacked, and their format. For this folder only.

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "adapters/occt/exchange/detail.h"

namespace blossom::occt {

/// The bytes of a file and their format.
struct FileText {
  Format format = Format::Step;
  std::string text;
  bool cut = false;                      ///< unpacking ended before the end
  std::string name = {};                 ///< in an archive of several models
  std::vector<std::string> others = {};  ///< the names of those that are not read
};

/// Bytes that were packed.
struct Unpacked {
  std::string text;
  bool cut = false;       ///< what is there came before a place where the packing is damaged
  std::string name = {};  ///< in an archive of several models
  std::vector<std::string> others = {};  ///< the names of other models in the archive
};

/// Reads a file, unpacks it if it is packed by gzip or zip, makes UTF-8 of wider letters, and finds
/// its format. A zip archive
/// gives the first model in it.
/// throws   BadModel with the cause, without the file's name, if it is no regular file, cannot be
///          read, is empty, larger than the memory, damaged in its packing or of no known format
FileText file_text(const std::filesystem::path& file);

/// The format that a content shows; none if it shows none.
std::optional<Format> format_of_content(std::string_view text);

/// What follows a byte-order mark, blanks and comments in the manner of STEP.
std::string_view after_preface(std::string_view text);

/// Whether a content is binary BREP; text has the same words without "Open".
bool is_binary_brep(std::string_view text);

/// Unpacks gzip or the first model of a zip archive; other bytes stay as they are.
/// throws   BadModel with the cause
Unpacked unpacked(std::string bytes);

/// Makes UTF-8 of UTF-16 and UTF-32, which are told by a byte-order mark or their first letters;
/// halves of letters become U+FFFD. Other bytes stay as they are.
void narrow_letters(std::string& bytes);

/// A letter's code in UTF-8 at the front of a text, beyond ASCII, and its length; 0 if it is none.
struct Utf8Letter {
  std::uint32_t code = 0;
  std::size_t length = 0;
};
Utf8Letter utf8_letter(std::string_view text);

/// A text of UTF-8 as it is, and any other as Latin-1.
std::string as_utf8(std::string_view letters);

/// White space by C's locale, or the 0 that files are padded with.
bool is_blank(char c);

}  // namespace blossom::occt
