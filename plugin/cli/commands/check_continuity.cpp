// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/commands/check_continuity.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <BRep_Tool.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Line.hxx>

#include "plugin/cli/commands/continuity_text.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/inputs.h"
#include "plugin/cli/interruption.h"
#include "plugin/cli/output.h"
#include "plugin/cli/picture/picture.h"
#include "plugin/cli/values.h"
#include "plugin/reports/repairs.h"

namespace blossom::cli {
namespace {

constexpr int kPictureSamples = 65;  // points of an edge in the picture

constexpr Vec3 kApartColour = {0.85, 0.10, 0.60};
constexpr Vec3 kSharpColour = {0.10, 0.11, 0.13};
constexpr Vec3 kTangentColour = {0.90, 0.49, 0.08};
constexpr Vec3 kSmoothColour = {0.13, 0.58, 0.25};
constexpr Vec3 kOpenColour = {0.82, 0.12, 0.12};

std::vector<occt::EdgeContinuity> measured(const Input& input, const ContinuityCommand& command) {
  occt::ContinuityOptions options;
  options.tolerances = command.tolerances;
  options.tick = [] { stop_if_interrupted(); };
  if (static_cast<int>(input.numbers.size()) != input.model.face_count())
    options.faces = input.numbers;
  return occt::edge_continuity(input.model.shape(), options);
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

Json report_of(const Input& input, const ContinuityReport& report) {
  Json summary, kinds, edges = Json::array();
  for (const char* word : kClassWords) summary[word] = report.count(word);
  summary["proven"] = report.proven();
  summary["unmeasured"] = report.unmeasured().size();
  for (int k = 0; k <= static_cast<int>(occt::EdgeRole::Inner); ++k) {
    const auto kind = static_cast<occt::EdgeRole>(k);
    kinds[to_string(kind)] = report.count(kind);
  }
  for (const occt::EdgeContinuity& edge : report.edges) edges.push_back(edge_json(edge));
  const std::string& require = report.command.require;
  return {{"schema", "blossom.continuity/1"},
          {"file", input.name},
          {"tolerances",
           {{"gap", report.command.tolerances.gap},
            {"angle", report.command.tolerances.angle},
            {"curvature", report.command.tolerances.curvature}}},
          {"require", require.empty() ? Json() : Json(require)},
          {"less_than_required", report.failing()},
          {"summary", std::move(summary)},
          {"kinds", std::move(kinds)},
          {"edges", std::move(edges)},
          {"repairs", Json::array({repairs_json(input)})}};
}

std::vector<Vec3> line_of(const TopoDS_Edge& edge) {
  Interval range;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, range.from, range.to);
  std::vector<Vec3> points;
  if (curve.IsNull()) return points;
  const int count = Handle(Geom_Line)::DownCast(curve).IsNull() ? kPictureSamples : 2;
  for (int i = 0; i < count; ++i) {
    const gp_Pnt p = curve->Value(at(range, i / (count - 1.0)));
    points.push_back({p.X(), p.Y(), p.Z()});
  }
  return points;
}

Vec3 colour_of(const occt::EdgeContinuity& edge) {
  if (!edge.found) return kOpenColour;
  switch (edge.smoothness) {
    case Smoothness::None: return kApartColour;
    case Smoothness::G0: return kSharpColour;
    case Smoothness::G1: return kTangentColour;
    case Smoothness::G2: break;
  }
  return kSmoothColour;
}

Picture picture_of(const Input& input, const ContinuityReport& report) {
  Picture picture;
  picture.groups = {{input.faces, kFirstColour, kFirstOpacity}};
  for (const occt::EdgeContinuity& edge : report.edges)
    if (std::vector<Vec3> points = line_of(edge.edge); !points.empty())
      picture.coloured.push_back({std::move(points), colour_of(edge)});
  return picture;
}

CLI::Option* needing(CLI::Option* option, CLI::Option* other) { return option->needs(other); }

}  // namespace

void add_continuity_options(CLI::App& command, CommonOptions& common, ContinuityCommand& options) {
  CLI::Option* const wanted = command.add_flag(
      "--continuity", options.wanted,
      "how smoothly faces meet instead: gap, angle of normals and curvature along every edge");
  const auto add_limit = [&](const char* name, double& value, const char* unit, const char* what) {
    needing(command.add_option(name, value, what), wanted)
        ->check(positive_number())
        ->type_name(unit)
        ->capture_default_str();
  };
  add_limit("--gap", options.tolerances.gap, "MM", "faces less apart meet (G0)");
  add_limit("--angle", options.tolerances.angle, "RAD", "normals less turned are one (G1)");
  add_limit("--curvature", options.tolerances.curvature, "PART",
            "curvatures that differ by less, relative to the larger, are one (G2)");
  CLI::Option* const require = command.add_option("--require", options.require,
                                                  "edges less smooth are findings; G0 without");
  limit_to(*needing(require, wanted), {"G0", "G1", "G2"});
  needing(command.add_flag("--edges", options.table, "print a line for every edge, as -v"), wanted);
  needing(command.add_option("--picture", common.picture,
                             "write a picture (PNG) with edges coloured by their class"),
          wanted)
      ->type_name("FILE");
}

int run_continuity(const std::string& name, const CommonOptions& common,
                   const ContinuityCommand& command) {
  check_files(common, {name});
  const Input input = read_input(name);
  stop_if_interrupted();
  const ContinuityReport report{command, measured(input, command)};
  stop_if_interrupted();
  if (!common.picture.empty())
    occt::write_text(picture_png(picture_of(input, report)), common.picture);
  if (!common.json.empty()) write_json(report_of(input, report), common.json);
  print_summary(continuity_text(input.name, report, !common.picture.empty()), common.json);
  return exit_code(kExitComplete, findings_of(!report.failing().empty()), common);
}

}  // namespace blossom::cli
