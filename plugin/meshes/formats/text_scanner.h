// SPDX-License-Identifier: LGPL-2.1-or-later
// Words and numbers of mesh files as text. For this folder only.

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/math/vec.h"

namespace blossom::meshes {

/// Goes through text word by word; lines end by "\n", "\r\n" or "\r".
class TextScanner {
 public:
  /// comment   what begins a comment that goes on to the end of its line; 0 for none
  explicit TextScanner(std::string_view text, char comment = 0) : text_(text), comment_(comment) {}

  /// The next word; empty at the end.
  std::string_view word();
  /// Likewise in lower case.
  std::string small_word();
  /// The rest of the line, without blanks at its ends; comments count as text.
  std::string_view rest_of_line();
  /// The next word of this line; empty at its end.
  std::string_view word_of_line();

  /// throws   BadContent, with the line, if the next word is no number or not finite
  double number();
  Vec3 point();
  /// throws   BadContent if it is no whole number
  std::int64_t whole();

  /// "line 12: ", of the word before.
  std::string place() const;
  std::size_t offset() const { return at_; }
  void move_to(std::size_t offset) { at_ = offset; }

 private:
  bool skip_blanks(bool over_lines);

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t word_ = 0;  // where the last one began
  char comment_;
};

/// throws   BadContent with `place` in front
double number_of(std::string_view word, const std::string& place);

}  // namespace blossom::meshes
