// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/text/number_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>

namespace blossom::reports {
namespace {

double rounded_to(int digits, double value) {
  if (value == 0 || !std::isfinite(value)) return value;
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*g", digits, value);
  return std::strtod(text.data(), nullptr);
}

}  // namespace

std::string number_text(double value) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  std::string text(digits.data(), end);
  // The standard library gives an exponent two digits at least.
  const std::size_t e = text.find('e');
  if (e != std::string::npos && text[e + 2] == '0') text.erase(e + 2, 1);
  if (e != std::string::npos && text[e + 1] == '+') text.erase(e + 1, 1);
  return text;
}

double rounded(double value) { return rounded_to(6, value); }

std::string seconds_text(double seconds) { return number_text(rounded_to(3, seconds)) + " s"; }

}  // namespace blossom::reports
