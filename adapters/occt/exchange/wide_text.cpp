// SPDX-License-Identifier: LGPL-2.1-or-later
// Text of two or four bytes a letter, as some programs of Windows write it, and of one.
//
// Source: The Unicode Standard, 3.9 and 3.10, on UTF-16 and UTF-32, their byte orders and marks.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "adapters/occt/exchange/file_text.h"

namespace blossom::occt {
namespace {

constexpr std::uint32_t kMark = 0xFEFF, kUnknownLetter = 0xFFFD;

/// How many bytes a letter has, and whether the least comes first.
struct Width {
  std::size_t bytes = 1;
  bool least_first = true;
};

std::uint32_t unit_at(std::string_view text, std::size_t place, Width width) {
  std::uint32_t unit = 0;
  for (std::size_t i = 0; i < width.bytes; ++i) {
    const std::size_t at = width.least_first ? width.bytes - 1 - i : i;
    unit = unit << 8U | static_cast<unsigned char>(text[place + at]);
  }
  return unit;
}

/// By a mark; or by the first letters, which are printed ones of ASCII in all formats of models.
bool is_of(std::string_view text, Width width) {
  constexpr std::size_t kLetters = 8;
  if (text.size() < width.bytes) return false;
  if (unit_at(text, 0, width) == kMark) return true;
  if (text.size() < kLetters * width.bytes) return false;
  for (std::size_t i = 0; i < kLetters; ++i) {
    const std::uint32_t letter = unit_at(text, i * width.bytes, width);
    if (letter > '~' || (letter < ' ' && (letter == 0 || !is_blank(static_cast<char>(letter)))))
      return false;
  }
  return true;
}

/// The wider ones first: their mark begins with that of the narrower.
Width width_of(std::string_view text) {
  for (const std::size_t bytes : {4, 2})
    for (const bool least_first : {true, false})
      if (const Width width{bytes, least_first}; is_of(text, width)) return width;
  return {};
}

bool is_first_half(std::uint32_t unit) { return 0xD800 <= unit && unit < 0xDC00; }
bool is_second_half(std::uint32_t unit) { return 0xDC00 <= unit && unit < 0xE000; }

void append_utf8(std::uint32_t code, std::string& text) {
  const auto put = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
  const auto tail = [&](unsigned shift) { put(0x80U | (code >> shift & 0x3FU)); };
  if (code < 0x80) return put(code);
  if (code < 0x800) {
    put(0xC0U | code >> 6U);
  } else if (code < 0x10000) {
    put(0xE0U | code >> 12U);
    tail(6);
  } else {
    put(0xF0U | code >> 18U);
    tail(12);
    tail(6);
  }
  tail(0);
}

}  // namespace

Utf8Letter utf8_letter(std::string_view text) {
  const auto byte = [&](std::size_t i) -> std::uint32_t {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  const std::uint32_t first = byte(0);
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : first >= 0xC2 ? 2 : 0;
  if (length == 0 || first > 0xF4) return {};
  std::uint32_t code = first & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return {};
    code = code << 6U | (byte(i) & 0x3FU);
  }
  constexpr std::uint32_t kSmallest[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_half = 0xD800 <= code && code <= 0xDFFF;
  return code < kSmallest[length] || code > 0x10FFFF || is_half ? Utf8Letter{}
                                                                : Utf8Letter{code, length};
}

std::string as_utf8(std::string_view letters) {
  std::string text;
  for (std::string_view rest = letters; !rest.empty();) {
    const bool ascii = static_cast<unsigned char>(rest.front()) < 0x80;
    const std::size_t length = ascii ? 1 : utf8_letter(rest).length;
    if (length == 0) {
      text.clear();
      for (const char c : letters) append_utf8(static_cast<unsigned char>(c), text);
      return text;
    }
    text += rest.substr(0, length);
    rest.remove_prefix(length);
  }
  return text;
}

void narrow_letters(std::string& bytes) {
  const Width width = width_of(bytes);
  if (width.bytes == 1) return;
  std::string text;
  text.reserve(bytes.size() / width.bytes);
  const auto unit = [&](std::size_t place) {
    return place + width.bytes <= bytes.size() ? unit_at(bytes, place, width) : 0U;
  };
  for (std::size_t i = 0; i + width.bytes <= bytes.size(); i += width.bytes) {
    std::uint32_t code = unit(i);
    if (i == 0 && code == kMark) continue;
    if (is_first_half(code) && is_second_half(unit(i + width.bytes))) {
      i += width.bytes;
      code = 0x10000U + ((code & 0x3FFU) << 10U) + (unit(i) & 0x3FFU);
    }
    const bool none = code > 0x10FFFF || is_first_half(code) || is_second_half(code);
    append_utf8(none ? kUnknownLetter : code, text);
  }
  bytes = std::move(text);
}

}  // namespace blossom::occt
