// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/blend_words.h"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/base/errors.h"

namespace blossom::reports {
namespace {

double positive_number(const std::string& text, const std::string& word) {
  std::size_t used = 0;
  double value = 0;
  try {
    value = std::stod(text, &used);
  } catch (const std::exception&) {
    used = 0;
  }
  if (used == 0 || used != text.size() || !(value > 0) || !std::isfinite(value))
    throw InvalidInput("\"" + word + "\": \"" + text + "\" is no positive number");
  return value;
}

// The text before and after a mark; nothing unless it has one.
std::optional<std::array<std::string, 2>> parted(const std::string& text, const std::string& mark) {
  const std::size_t at = text.find(mark);
  if (at == std::string::npos) return std::nullopt;
  return std::array{text.substr(0, at), text.substr(at + mark.size())};
}

}  // namespace

void read_radius(const std::string& word, occt::FilletOptions& of) {
  if (const auto both = parted(word, "..")) {
    of.radius = positive_number((*both)[0], word);
    of.last_radius = positive_number((*both)[1], word);
  } else {
    of.radius = positive_number(word, word);
  }
}

void read_section(const std::string& word, occt::FilletOptions& of) {
  if (word == "circle") return;
  const auto conic = parted(word, "conic:");
  if (!conic || !(*conic)[0].empty())
    throw InvalidInput("a section is circle or conic:RHO, as in conic:0.4, not \"" + word + "\"");
  of.rho = positive_number((*conic)[1], word);
  if (*of.rho >= 1) throw InvalidInput("\"" + word + "\": rho has to be below 1");
}

occt::ChamferSize chamfer_size(const std::string& word) {
  occt::ChamferSize size;
  if (const auto both = parted(word, ",")) {
    size.first = positive_number((*both)[0], word);
    size.second = positive_number((*both)[1], word);
  } else if (const auto angled = parted(word, ":")) {
    size.first = positive_number((*angled)[0], word);
    const double degrees = positive_number((*angled)[1], word);
    if (degrees >= 180)
      throw InvalidInput("\"" + word + "\": the angle has to be below 180 degrees");
    size.angle = degrees * std::numbers::pi / 180;
  } else {
    size.first = positive_number(word, word);
  }
  return size;
}

}  // namespace blossom::reports
