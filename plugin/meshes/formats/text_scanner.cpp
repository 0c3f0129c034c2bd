// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/meshes/formats/text_scanner.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <system_error>

#include "plugin/meshes/formats/mesh_formats.h"
#include "plugin/reports/text/lower_case.h"

namespace blossom::meshes {
namespace {

constexpr std::size_t kShownWord = 40;  // bytes of a word that messages have

bool is_line_end(char c) { return c == '\n' || c == '\r'; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f' || is_line_end(c); }

std::string shown(std::string_view word) {
  std::string text(word.substr(0, kShownWord));
  std::ranges::replace_if(
      text, [](unsigned char c) { return std::isprint(c) == 0; }, '?');
  return "'" + text + "'";
}

// Without the sign that from_chars does not take.
std::string_view without_plus(std::string_view word) {
  return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}

}  // namespace

double number_of(std::string_view word, const std::string& place) {
  if (word.empty())
    throw BadContent(place + "the file ends where a number is wanted: it is cut off");
  const std::string_view text = without_plus(word);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = end == text.data() + text.size();
  // Numbers below the smallest double are 0.
  if (error == std::errc::result_out_of_range && whole && text.find("e-") != text.npos) return 0;
  if (error == std::errc::result_out_of_range && whole && text.find("E-") != text.npos) return 0;
  if (error != std::errc() || !whole) throw BadContent(place + shown(word) + " is no number");
  if (!std::isfinite(value)) throw BadContent(place + shown(word) + " is no finite number");
  return value;
}

bool TextScanner::skip_blanks(bool over_lines) {
  while (at_ < text_.size()) {
    const char c = text_[at_];
    if (comment_ != 0 && c == comment_) {
      while (at_ < text_.size() && !is_line_end(text_[at_])) ++at_;
    } else if (is_blank(c) && (over_lines || !is_line_end(c))) {
      ++at_;
    } else {
      break;
    }
  }
  return at_ < text_.size() && !is_line_end(text_[at_]);
}

std::string_view TextScanner::word() {
  skip_blanks(true);
  word_ = at_;
  while (at_ < text_.size() && !is_blank(text_[at_])) ++at_;
  return text_.substr(word_, at_ - word_);
}

std::string_view TextScanner::word_of_line() {
  if (!skip_blanks(false)) return {};
  return word();
}

std::string TextScanner::small_word() { return reports::lower_case(std::string(word())); }

std::string_view TextScanner::rest_of_line() {
  while (at_ < text_.size() && is_blank(text_[at_]) && !is_line_end(text_[at_])) ++at_;
  const std::size_t from = at_;
  while (at_ < text_.size() && !is_line_end(text_[at_])) ++at_;
  std::string_view rest = text_.substr(from, at_ - from);
  while (!rest.empty() && is_blank(rest.back())) rest.remove_suffix(1);
  return rest;
}

double TextScanner::number() {
  const std::string_view next = word();
  const std::string_view text = without_plus(next);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc() && end == text.data() + text.size() && std::isfinite(value))
    return value;
  return number_of(next, place());
}

Vec3 TextScanner::point() {
  Vec3 made;
  for (int k = 0; k < 3; ++k) made[k] = number();
  return made;
}

std::int64_t TextScanner::whole() {
  const std::string_view next = word();
  if (next.empty()) number_of(next, place());
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(next.data(), next.data() + next.size(), value);
  if (error != std::errc() || end != next.data() + next.size())
    throw BadContent(place() + shown(next) + " is no whole number");
  return value;
}

std::string TextScanner::place() const {
  std::size_t line = 1;
  for (std::size_t k = 0; k < word_; ++k)
    line +=
        text_[k] == '\n' || (text_[k] == '\r' && (k + 1 == text_.size() || text_[k + 1] != '\n'));
  return "line " + std::to_string(line) + ": ";
}

}  // namespace blossom::meshes
