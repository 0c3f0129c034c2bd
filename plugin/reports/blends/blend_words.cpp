// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/blends/blend_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <vector>

#include "core/base/errors.h"
#include "plugin/reports/models/entity_words.h"
#include "plugin/reports/text/json.h"
#include "plugin/reports/text/nesting.h"

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
    throw InvalidInput((text == word ? "" : "\"" + word + "\": ") + "\"" + text +
                       "\" is no positive number");
  return value;
}

// The text before and after a mark; nothing unless it has one.
std::optional<std::array<std::string, 2>> parted(const std::string& text, const std::string& mark) {
  const std::size_t at = text.find(mark);
  if (at == std::string::npos) return std::nullopt;
  return std::array{text.substr(0, at), text.substr(at + mark.size())};
}

std::vector<double> numbers_of(const Json& law, const char* name) {
  std::vector<double> numbers;
  const auto found = law.find(name);
  if (found != law.end() && found->is_array())
    for (const Json& each : *found) {
      if (!each.is_number()) break;
      numbers.push_back(each.get<double>());
    }
  if (numbers.empty() || numbers.size() != found->size())
    throw InvalidInput(std::string("a law has a list of numbers \"") + name + "\"");
  return numbers;
}

}  // namespace

double positive_size(const std::string& word) { return positive_number(word, word); }

occt::EdgeRadius edge_radius(const std::string& word) {
  const auto both = parted(word, "..");
  if (!both) return {positive_number(word, word), {}};
  const double first = positive_number((*both)[0], word);
  return {1, RadiusLaw::linear({0, 1}, first, positive_number((*both)[1], word))};
}

void choose_edges(const std::string& word, EdgeChoice& choice) {
  const auto with_radius = parted(word, ":");
  const auto range = entity_range(with_radius ? (*with_radius)[0] : word, "edge");
  if (!range)
    throw InvalidInput("\"" + word +
                       "\" is no edge: 12, Edge12 or 5-9, or 12:5 with a radius, is wanted");
  for (int edge = range->first; edge <= range->last; ++edge) {
    choice.edges.push_back(edge);
    if (with_radius && !choice.own.emplace(edge, edge_radius((*with_radius)[1])).second)
      throw InvalidInput("edge " + std::to_string(edge) + " has two radii");
  }
}

RadiusLaw radius_law(const std::string& json) {
  const Json law = is_nested_soundly(json) ? Json::parse(json, nullptr, false) : Json();
  if (!law.is_object()) throw InvalidInput("a law is a JSON object");
  const Json kind = law.value("law", Json());
  if (kind != "linear" && kind != "smooth" && kind != "table")
    throw InvalidInput("a law's \"law\" is \"linear\", \"smooth\" or \"table\"");
  const std::vector<double> radii = numbers_of(law, "radii");
  if (std::ranges::any_of(radii, [](double r) { return !(r > 0) || !std::isfinite(r); }))
    throw InvalidInput("a law's \"radii\" are positive");
  if (kind == "table") {
    const std::vector<double> at = numbers_of(law, "at");
    if (at.front() != 0 || at.back() != 1)
      throw InvalidInput("a law's \"at\" begins with 0 and ends with 1");
    if (std::ranges::adjacent_find(at, std::greater_equal<>()) != at.end())
      throw InvalidInput("a law's \"at\" grows from each number to the next");
    if (at.size() != radii.size())
      throw InvalidInput("a law that is a table has as many \"radii\" as \"at\"");
    return RadiusLaw::table(at, radii);
  }
  if (radii.size() != 2)
    throw InvalidInput("a law that is no table has two \"radii\", at the start and at the end");
  return kind == "linear" ? RadiusLaw::linear({0, 1}, radii[0], radii[1])
                          : RadiusLaw::smooth({0, 1}, radii[0], radii[1]);
}

occt::FilletSection fillet_section(const std::string& word) {
  if (word == "circle") return {};
  if (word == "g2") return {.kind = SectionKind::Curvature};
  if (word == "g3") return {.kind = SectionKind::CurvatureRate};
  const auto conic = parted(word, "conic:");
  if (!conic || !(*conic)[0].empty())
    throw InvalidInput("a section is circle, conic:RHO, as in conic:0.4, g2 or g3, not \"" + word +
                       "\"");
  const double rho = positive_number((*conic)[1], word);
  if (rho >= 1) throw InvalidInput("\"" + word + "\": rho has to be below 1");
  return {.kind = SectionKind::Conic, .rho = rho};
}

std::string section_name(const occt::FilletSection& section) {
  switch (section.kind) {
    case SectionKind::Conic: return "conic";
    case SectionKind::Curvature: return "g2";
    case SectionKind::CurvatureRate: return "g3";
    default: return "circle";
  }
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
