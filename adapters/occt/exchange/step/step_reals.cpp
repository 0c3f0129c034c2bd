// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/exchange/step/step_reals.h"

#include <cstddef>
#include <string_view>
#include <utility>

#include "adapters/occt/exchange/step/step_scan.h"

namespace blossom::occt {
namespace {

bool is_sign(char c) { return c == '+' || c == '-'; }

std::size_t behind_digits(std::string_view text, std::size_t place) {
  while (place < text.size() && is_digit(text[place])) ++place;
  return place;
}

/// Where the letter of an exponent stands, and whether the number before it has a point.
struct Exponent {
  std::size_t letter = kNowhere;
  bool has_point = false;
};

/// The exponent of a number that begins at a place with its first digit or point.
Exponent exponent_from(std::string_view text, std::size_t place) {
  std::size_t letter = behind_digits(text, place);
  const bool has_point = letter < text.size() && text[letter] == '.';
  const std::size_t digits = letter - place;
  if (has_point) letter = behind_digits(text, letter + 1);
  if (letter - place == (has_point ? 1U : 0U) || (digits == 0 && !has_point)) return {};
  if (letter >= text.size() || std::string_view("eEdD").find(text[letter]) == kNowhere) return {};
  const std::size_t power = letter + 1 + (letter + 1 < text.size() && is_sign(text[letter + 1]));
  if (behind_digits(text, power) == power) return {};
  return {letter, has_point};
}

/// Whether the character before a place lets a number begin there.
bool begins_number(std::string_view text, std::size_t place) {
  const char before = place == 0 ? ' ' : text[place - 1];
  return before == '(' || before == ',' || is_sign(before) || is_blank(before);
}

/// Calls `take` with the exponents outside of strings and comments.
template <class Take>
void for_each_exponent(std::string_view text, const Take& take) {
  for (std::size_t place = 0; place < text.size();) {
    if (const std::size_t behind = behind_quoted(text, place); behind > place) {
      place = behind;
      continue;
    }
    const bool is_number =
        (is_digit(text[place]) || text[place] == '.') && begins_number(text, place);
    const Exponent found = is_number ? exponent_from(text, place) : Exponent{};
    if (found.letter != kNowhere) take(found);
    place = found.letter == kNowhere ? place + 1 : found.letter + 1;
  }
}

}  // namespace

void mend_reals(std::string& text) {
  std::string mended;
  std::size_t done = 0;
  for_each_exponent(text, [&](const Exponent& exponent) {
    if (exponent.has_point && text[exponent.letter] == 'E') return;
    mended.append(text, done, exponent.letter - done).append(exponent.has_point ? "E" : ".E");
    done = exponent.letter + 1;
  });
  if (done == 0) return;
  mended.append(text, done);
  text = std::move(mended);
}

}  // namespace blossom::occt
