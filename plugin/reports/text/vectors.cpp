// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/text/vectors.h"

#include <cmath>
#include <cstddef>
#include <exception>
#include <sstream>

namespace blossom::reports {

std::optional<double> finite_value(const std::string& text) {
  try {
    std::size_t used = 0;
    const double value = std::stod(text, &used);
    if (used == text.size() && std::isfinite(value)) return value;
  } catch (const std::exception&) {  // no number
  }
  return std::nullopt;
}

std::optional<std::vector<double>> finite_numbers(const std::string& text) {
  std::vector<double> numbers;
  std::size_t start = 0, comma = 0;
  while (comma != std::string::npos) {
    comma = text.find(',', start);
    const std::optional<double> number = finite_value(text.substr(start, comma - start));
    if (!number) return std::nullopt;
    numbers.push_back(*number);
    start = comma + 1;
  }
  return numbers;
}

Vec3 without_roundings(const Vec3& v) {
  constexpr double kNothing = 1e-12;  // of the largest
  Vec3 shown = v;
  for (int k = 0; k < 3; ++k)
    if (std::abs(v[k]) <= kNothing * max_norm(v)) shown[k] = 0;
  return shown;
}

std::string vector_text(const Vec3& v) {
  std::ostringstream text;
  text.precision(12);
  text << "(" << v[0] << ", " << v[1] << ", " << v[2] << ")";
  return text.str();
}

}  // namespace blossom::reports
