// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom info F`: what a model is made of, and whether it is sound.

#include <iomanip>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "adapters/occt/soundness.h"
#include "plugin/cli/commands/commands.h"
#include "plugin/cli/edge_list.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/inputs.h"
#include "plugin/cli/interruption.h"
#include "plugin/cli/options.h"
#include "plugin/cli/output.h"
#include "plugin/cli/reading.h"
#include "plugin/reports/info.h"

namespace blossom::cli {
namespace {

using reports::FaceFacts;
using reports::ModelFacts;

constexpr double kUsualPrecision = 2e-7;  // of a box, model units: what is not told

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
  for (const auto& [number, one, many] : reports::shape_counts(input.model.shape()))
    text << " " << number << " " << (number == 1 ? one : many);
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
  const auto problems =
      occt::face_problems(input.faces, input.numbers, watched_checks(input.model.file()));
  const ModelFacts facts = reports::model_facts(input, problems, interrupted);
  stop_if_interrupted();
  const std::string& json = options.common.json;
  Json report = reports::info_report(input, facts);
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
