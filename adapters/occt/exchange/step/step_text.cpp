// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/exchange/step/step_text.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

#include "adapters/occt/exchange/file_text.h"
#include "adapters/occt/exchange/step/step_entities.h"
#include "adapters/occt/exchange/step/step_numbers.h"
#include "adapters/occt/exchange/step/step_reals.h"
#include "adapters/occt/exchange/step/step_scan.h"
#include "adapters/occt/exchange/step/step_sections.h"

namespace blossom::occt {
namespace {

constexpr std::string_view kFileEnd = "END-ISO-10303-21";
constexpr std::size_t kNone = std::string::npos;

char upper(char c) { return static_cast<char>(std::toupper(static_cast<unsigned char>(c))); }
/// The last place of a word in capitals, in either case.
std::size_t last_place(std::string_view text, std::string_view word) {
  for (std::size_t i = text.size() + 1 - std::min(text.size() + 1, word.size()); i-- > 0;)
    if (upper(text[i]) == word.front() && has_word(text, i, word)) return i;
  return kNone;
}

/// Capitals outside of strings and comments.
void capitalize(std::string& text) {
  for (std::size_t place = 0; place < text.size();) {
    const std::size_t behind = behind_quoted(text, place);
    if (behind == place) text[place] = upper(text[place]);
    place = behind == place ? place + 1 : behind;
  }
}

/// The place behind the last entity that is there to its end, ")" and ";".
std::size_t end_of_entities(std::string_view text) {
  for (std::size_t i = text.rfind(';'); i != kNone && i > 0; i = text.rfind(';', i - 1)) {
    std::size_t before = i - 1;
    while (before > 0 && is_blank(text[before])) --before;
    if (text[before] == ')') return i + 1;
  }
  return 0;
}

void close(std::string& text, ReadingReport& report) {
  const std::size_t last = end_of_entities(text);
  const bool data_ends = has_word(text, text.find_first_not_of(" \t\r\n", last), "ENDSEC");
  text.resize(last);
  text += "\nENDSEC;\nEND-ISO-10303-21;\n";
  if (data_ends)
    report.add({"the file's last line", "END-ISO-10303-21 is missing"});
  else
    report.add({"the rest of the file", "it is cut off", true});
}

// --- letters that STEP has codes for

bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }

/// What STEP gives no meaning, and a terminal may obey; tabs, too, of which Open CASCADE takes some
/// for a part of what stands beside them.
bool is_control(char c) {
  return std::iscntrl(static_cast<unsigned char>(c)) != 0 && c != '\n' && c != '\r';
}

void append_hex(std::uint32_t number, int digits, std::string& text) {
  for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4)
    text += "0123456789ABCDEF"[number >> shift & 0xFU];
}

/// UTF-16 in hexadecimal, as "\X2\" has it; empty if the letters are no UTF-8.
std::string utf16_digits(std::string_view letters) {
  std::string digits;
  while (!letters.empty()) {
    const auto [code, length] = utf8_letter(letters);
    if (length == 0) return {};
    if (code >= 0x10000) append_hex(0xD800U + ((code - 0x10000U) >> 10U), 4, digits);
    append_hex(code >= 0x10000 ? 0xDC00U + (code & 0x3FFU) : code, 4, digits);
    letters.remove_prefix(length);
  }
  return digits;
}

/// Letters beyond ASCII in STEP's codes. Programs write them as UTF-8, or in the code page of their
/// system, of which Latin-1 is a part.
void append_coded(std::string_view letters, std::string& text) {
  if (const std::string digits = utf16_digits(letters); !digits.empty()) {
    text += "\\X2\\" + digits + "\\X0\\";
    return;
  }
  for (const char c : letters) {
    text += "\\X\\";
    append_hex(static_cast<unsigned char>(c), 2, text);
  }
}

void code_letters(std::string& text) {
  if (std::ranges::none_of(text, [](char c) { return !is_ascii(c) || is_control(c); })) return;
  std::string coded;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && !is_ascii(text[end])) ++end;
    if (end > i) {
      append_coded(std::string_view(text).substr(i, end - i), coded);
      i = end;
    } else {
      coded += is_control(text[i]) ? ' ' : text[i];
      ++i;
    }
  }
  text = std::move(coded);
}

}  // namespace

void mend_step_text(std::string& text, ReadingReport& report) {
  text.erase(0, text.size() - after_preface(text).size());
  const std::size_t end = last_place(text, kFileEnd);
  if (end == kNone)
    close(text, report);
  else
    text.replace(end, text.size() - end, "END-ISO-10303-21;\n");
  if (has_small_keywords(text)) capitalize(text);
  mend_reals(text);
  code_letters(text);
  mend_step_sections(text);
  open_scopes(text);
  drop_repeated_entities(text, report);
  open_edge_circles(text);
  fill_empty_lists(text);
  sort_complex_entities(text);
  renumber_large_entities(text);
}

}  // namespace blossom::occt
