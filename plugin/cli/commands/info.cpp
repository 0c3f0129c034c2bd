// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom info F`: what a model is made of, and whether it is sound.

#include <algorithm>
#include <array>
#include <cstdio>
#include <iomanip>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include <ShapeAnalysis_ShapeTolerance.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/queries/least_box.h"
#include "adapters/occt/soundness.h"
#include "plugin/cli/commands/commands.h"
#include "plugin/cli/edge_list.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/face_facts.h"
#include "plugin/cli/inputs.h"
#include "plugin/cli/interruption.h"
#include "plugin/cli/options.h"
#include "plugin/cli/output.h"
#include "plugin/cli/reading.h"

namespace blossom::cli {
namespace {

struct Counted {
  TopAbs_ShapeEnum kind;
  const char* one;
  const char* many;
};

constexpr std::array kCounted = {
    Counted{TopAbs_SOLID, "solid", "solids"}, Counted{TopAbs_SHELL, "shell", "shells"},
    Counted{TopAbs_FACE, "face", "faces"}, Counted{TopAbs_EDGE, "edge", "edges"},
    Counted{TopAbs_VERTEX, "vertex", "vertices"}};

constexpr double kUsualPrecision = 2e-7;  // of a box, model units: what is not told

struct ModelFacts {
  std::vector<FaceFacts> faces;
  std::map<std::string, int> surfaces;  ///< faces per surface type
  std::optional<occt::LeastBox> box;
  double least_tolerance = 0;  ///< of faces, edges and vertices, model units
  double largest_tolerance = 0;
  bool valid = true;  ///< every listed face is
};

// None of what has no vertex, or no end.
std::optional<occt::LeastBox> box_of(const TopoDS_Shape& shape) try {
  return occt::least_box(shape, interrupted);
} catch (const occt::BadModel&) {
  return std::nullopt;
}

ModelFacts model_facts(const Input& input) {
  ModelFacts facts;
  const std::vector<std::string> names = input.model.face_names();
  const auto problems =
      occt::face_problems(input.faces, input.numbers, watched_checks(input.model.file()));
  for (std::size_t i = 0; i < input.faces.size(); ++i) {
    facts.faces.push_back(face_facts(input.faces[i], input.numbers[i], problems[i]));
    FaceFacts& face = facts.faces.back();
    face.name = given_name(names[static_cast<std::size_t>(face.number - 1)]);
    ++facts.surfaces[face.surface];
    facts.valid = facts.valid && face.problems.empty();
  }
  ShapeAnalysis_ShapeTolerance tolerances;
  facts.least_tolerance = tolerances.Tolerance(input.model.shape(), -1);
  facts.largest_tolerance = tolerances.Tolerance(input.model.shape(), 1);
  // Numbers that are none would go into the box, too.
  if (facts.valid) facts.box = box_of(input.model.shape());
  return facts;
}

int count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, kind, map);
  return map.Extent();
}

Json face_json(const FaceFacts& face) {
  Json json = {{"number", face.number}, {"name", face.name}, {"surface", face.surface}};
  if (face.degree_u > 0) {
    json["degree"] = {face.degree_u, face.degree_v};
    json["spans"] = {face.spans_u, face.spans_v};
    json["rational"] = face.rational;
  }
  json["periodic"] = {face.periodic_u, face.periodic_v};
  json["wires"] = face.wires;
  json["edges"] = face.edges;
  json["tolerance"] = face.tolerance;
  json["valid"] = face.problems.empty();
  json["problems"] = face.problems;
  return json;
}

Json info_json(const Input& input, const ModelFacts& facts) {
  Json json = {{"schema", "blossom.info/1"},
               {"file", input.name},
               {"unit", "mm"},
               {"file_unit", input.model.file_unit()}};
  for (const auto& [kind, one, many] : kCounted)
    json["counts"][many] = count(input.model.shape(), kind);
  json["surfaces"] = facts.surfaces;
  json["box"] = nullptr;
  if (facts.box) {
    json["box"] = {facts.box->box.low.coordinates, facts.box->box.high.coordinates};
    json["box_precision"] = facts.box->precision;
  }
  json["tolerance"] = {{"least", facts.least_tolerance}, {"largest", facts.largest_tolerance}};
  json["valid"] = facts.valid;
  json["faces"] = Json::array();
  for (const FaceFacts& face : facts.faces) json["faces"].push_back(face_json(face));
  return json;
}

std::string face_line(const FaceFacts& face) {
  std::ostringstream line;
  line << std::setw(6) << face.number << "  " << std::left << std::setw(11) << face.surface;
  std::ostringstream form;
  if (face.degree_u > 0) {
    form << "degree " << face.degree_u << " x " << face.degree_v << ", spans " << face.spans_u
         << " x " << face.spans_v << (face.rational ? ", rational" : "");
  }
  line << std::setw(42) << form.str() << std::setw(10) << face.tolerance
       << (face.problems.empty() ? "valid  " : "NOT VALID: ");
  for (std::size_t i = 0; i < face.problems.size(); ++i)
    line << (i == 0 ? "" : "; ") << face.problems[i];
  line << (face.name.empty() || face.problems.empty() ? "" : "  ") << face.name << "\n";
  return line.str();
}

std::string corner_text(const Vec3& corner) {
  std::ostringstream text;
  text << "[" << corner[0] << ", " << corner[1] << ", " << corner[2] << "]";
  return text.str();
}

std::string info_text(const Input& input, const ModelFacts& facts) {
  std::ostringstream text;
  text << input.name << "\n ";
  for (const auto& [kind, one, many] : kCounted) {
    const int number = count(input.model.shape(), kind);
    text << " " << number << " " << (number == 1 ? one : many);
  }
  text << "\n  surfaces:";
  for (const auto& [word, number] : facts.surfaces) text << " " << number << " " << word;
  if (facts.box)
    text << "\n  box (mm): " << corner_text(facts.box->box.low) << " to "
         << corner_text(facts.box->box.high);
  if (facts.box && facts.box->precision > kUsualPrecision) text << ", to " << facts.box->precision;
  text << "\n  tolerances: " << facts.least_tolerance << " to " << facts.largest_tolerance << "\n  "
       << (facts.valid ? "valid" : "NOT VALID") << ", file in " << input.model.file_unit() << "\n";
  if (!facts.faces.empty())
    text << "  face  surface    form" << std::string(38, ' ') << "tolerance validity, name\n";
  for (const FaceFacts& face : facts.faces) text << face_line(face);
  return text.str();
}

struct Options {
  std::string input;
  bool edges = false;
  CommonOptions common;
};

int run(const Options& options) {
  check_files(options.common, {options.input});
  const Input input = read_input(options.input, Faces::Optional, Repair::None);
  const ModelFacts facts = model_facts(input);
  stop_if_interrupted();
  const std::string& json = options.common.json;
  Json report = info_json(input, facts);
  std::string text = info_text(input, facts);
  if (options.edges) {
    const EdgeList edges = edge_list(input.model.shape());
    report["edges"] = edges.json;
    text += edges.text;
  }
  if (!json.empty()) write_json(report, json);
  print_summary(text, json);
  return kExitComplete;
}

}  // namespace

void add_info(CLI::App& app, int& exit_code) {
  CLI::App* const command =
      app.add_subcommand("info", "faces by surface type, degrees, spans, tolerances, validity");
  const auto options = std::make_shared<Options>();
  command->add_option("input", options->input, "model, or some of its faces")
      ->required()
      ->type_name("FILE");
  command->add_flag("--edges", options->edges,
                    "list all edges of the model, too: faces, kind, angle, length, middle");
  add_report_options(*command, options->common);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace blossom::cli
