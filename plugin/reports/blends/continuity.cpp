// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/blends/continuity.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "plugin/reports/models/repairs.h"

namespace blossom::reports {
namespace {

using occt::EdgeContinuity;
using occt::EdgeRole;

bool is_measurable(const EdgeContinuity& edge) {
  return edge.kind == EdgeRole::Shared || edge.kind == EdgeRole::Seam;
}

Json figure_json(const LargestFound& found, const std::optional<double>& bound) {
  return {{"value", found.value},
          {"bound", bound ? Json(*bound) : Json()},
          {"parameter", found.parameter},
          {"point", Json::array({found.point[0], found.point[1], found.point[2]})}};
}

Json figures_json(const occt::EdgeContinuity& edge) {
  const MeasuredContinuity& found = *edge.found;
  const auto bound = [&](double ContinuityBounds::*member) {
    return edge.bounds ? std::optional<double>((*edge.bounds).*member) : std::nullopt;
  };
  Json json = {{"gap", figure_json(found.gap, bound(&ContinuityBounds::gap))}};
  const bool has_normals = found.singular < found.samples;
  json["angle"] = has_normals ? figure_json(found.angle, bound(&ContinuityBounds::angle)) : Json();
  const bool smooth = edge.smoothness >= Smoothness::G1;
  json["curvature"] =
      smooth ? figure_json(found.curvature, bound(&ContinuityBounds::curvature)) : Json();
  json["curvature_difference"] =
      smooth ? figure_json(found.difference, bound(&ContinuityBounds::difference)) : Json();
  json["samples"] = found.samples;
  json["singular_samples"] = found.singular;
  return json;
}

Json edge_json(const occt::EdgeContinuity& edge) {
  Json json = {{"number", edge.number}, {"faces", edge.faces}, {"kind", to_string(edge.kind)}};
  json["class"] = edge.found ? Json(class_word(edge)) : Json();
  if (edge.found) {
    json["proven"] = edge.proven;
    json.update(figures_json(edge));
    if (!edge.bounds) json["no_bounds"] = edge.no_bounds;
  }
  if (!edge.problem.empty()) json["problem"] = edge.problem;
  return json;
}

}  // namespace

const char* class_word(const EdgeContinuity& edge) {
  return kClassWords[static_cast<std::size_t>(edge.smoothness)];
}

std::size_t ContinuityAnswer::count(std::string_view word) const {
  return static_cast<std::size_t>(std::ranges::count_if(
      edges, [&](const EdgeContinuity& edge) { return edge.found && class_word(edge) == word; }));
}

std::size_t ContinuityAnswer::count(EdgeRole kind) const {
  return static_cast<std::size_t>(
      std::ranges::count_if(edges, [&](const EdgeContinuity& edge) { return edge.kind == kind; }));
}

std::size_t ContinuityAnswer::proven() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(edges, [](const EdgeContinuity& edge) { return edge.proven; }));
}

std::vector<const EdgeContinuity*> ContinuityAnswer::unmeasured() const {
  std::vector<const EdgeContinuity*> found;
  for (const EdgeContinuity& edge : edges)
    if (is_measurable(edge) && !edge.found) found.push_back(&edge);
  return found;
}

std::vector<int> ContinuityAnswer::failing() const {
  const Smoothness wanted = require == "G2"   ? Smoothness::G2
                            : require == "G1" ? Smoothness::G1
                                              : Smoothness::G0;
  std::vector<int> numbers;
  for (const EdgeContinuity& edge : edges)
    if (is_measurable(edge) && (!edge.found || edge.smoothness < wanted))
      numbers.push_back(edge.number);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

ContinuityAnswer measured_continuity_of(const Input& input, const ContinuityTolerances& tolerances,
                                        const std::string& require,
                                        const std::function<void()>& tick) {
  occt::ContinuityOptions options;
  options.tolerances = tolerances;
  options.tick = tick;
  if (static_cast<int>(input.numbers.size()) != input.model.face_count())
    options.faces = input.numbers;
  return {tolerances, require, occt::edge_continuity(input.model.shape(), options)};
}

Json continuity_report(const Input& input, const ContinuityAnswer& report) {
  Json summary, kinds, edges = Json::array();
  for (const char* word : kClassWords) summary[word] = report.count(word);
  summary["proven"] = report.proven();
  summary["unmeasured"] = report.unmeasured().size();
  for (int k = 0; k <= static_cast<int>(occt::EdgeRole::Inner); ++k) {
    const auto kind = static_cast<occt::EdgeRole>(k);
    kinds[to_string(kind)] = report.count(kind);
  }
  for (const occt::EdgeContinuity& edge : report.edges) edges.push_back(edge_json(edge));
  const std::string& require = report.require;
  return {{"schema", "blossom.continuity/1"},
          {"file", input.name},
          {"tolerances",
           {{"gap", report.tolerances.gap},
            {"angle", report.tolerances.angle},
            {"curvature", report.tolerances.curvature}}},
          {"require", require.empty() ? Json() : Json(require)},
          {"less_than_required", report.failing()},
          {"summary", std::move(summary)},
          {"kinds", std::move(kinds)},
          {"edges", std::move(edges)},
          {"repairs", Json::array({repairs_json(input)})}};
}

}  // namespace blossom::reports
