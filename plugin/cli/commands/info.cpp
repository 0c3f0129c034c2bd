// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom info F`: what a model is made of, and whether it is sound.

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iomanip>
#include <memory>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "adapters/occt/soundness.h"
#include "core/bounds/box_tree.h"
#include "plugin/cli/arguments/inputs.h"
#include "plugin/cli/arguments/options.h"
#include "plugin/cli/arguments/values.h"
#include "plugin/cli/commands/commands.h"
#include "plugin/cli/commands/meshes/mesh_commands.h"
#include "plugin/cli/commands/meshes/meshed_input.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/output/edge_list.h"
#include "plugin/cli/output/output.h"
#include "plugin/cli/output/reading.h"
#include "plugin/cli/output/tree_list.h"
#include "plugin/cli/output/verbosity.h"
#include "plugin/cli/picture/files.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/cli/process/many_files.h"
#include "plugin/pictures/results/models.h"
#include "plugin/reports/models/info.h"

namespace blossom::cli {
namespace {

using reports::FaceFacts;
using reports::ModelFacts;

constexpr double kUsualPrecision = 2e-7;   // of a box, model units: what is not told
constexpr double kCornerRounding = 1e-12;  // of a box's size: so small, a coordinate is 0
constexpr int kCornerDigits = 6;           // of a coordinate

// What lines of faces leave out.
std::string place_text(const reports::Measures& of) {
  if (!of.point) return {};
  if (!of.direction) return ", centre " + reports::triple(*of.point);
  return ", axis " + reports::triple(*of.direction) + " through " + reports::triple(*of.point);
}

// As in pages of the web.
std::string colour_text(const occt::FaceColour& colour) {
  std::ostringstream text;
  text << '#' << std::hex << std::setfill('0');
  for (const double part : colour) text << std::setw(2) << std::lround(255 * part);
  return text.str();
}

std::string face_line(const FaceFacts& face) {
  std::ostringstream line;
  line << std::setw(6) << face.number << "  " << std::left << std::setw(11) << face.surface;
  std::ostringstream form;
  if (face.degree_u > 0) {
    form << "degree " << face.degree_u << " x " << face.degree_v << ", spans " << face.spans_u
         << " x " << face.spans_v << (face.rational ? ", rational" : "");
  }
  form << reports::measures_text(face.measures);
  // A degree sign takes two bytes.
  line << std::setw(face.measures.half_angle ? 37 : 36) << form.str() << " " << std::setw(12)
       << (face.area ? number_text(rounded(*face.area)) : "") << std::setw(12) << face.tolerance
       << (face.problems.empty() ? "valid  " : "NOT VALID: ");
  for (std::size_t i = 0; i < face.problems.size(); ++i)
    line << (i == 0 ? "" : "; ") << face.problems[i];
  if (face.colour) line << (face.problems.empty() ? "" : "  ") << colour_text(*face.colour) << "  ";
  line << (face.name.empty() || face.problems.empty() ? "" : "  ") << face.name << "\n";
  if (verbosity() == Verbosity::Verbose && face.surface != "none")
    line << "        u " << face.u.from << " to " << face.u.to << ", v " << face.v.from << " to "
         << face.v.to << place_text(face.measures) << "\n";
  return line.str();
}

int decimal_exponent(double x) { return static_cast<int>(std::floor(std::log10(std::abs(x)))); }

// Six digits, and as many more as a box far from the origin takes to show its size.
std::string corner_text(const Vec3& corner, double size) {
  std::ostringstream text;
  for (int k = 0; k < 3; ++k) {
    const double x = std::abs(corner[k]) <= kCornerRounding * size ? 0 : corner[k];
    const int beyond = x != 0 && size > 0 ? decimal_exponent(x) - decimal_exponent(size) : 0;
    text << (k == 0 ? "[" : ", ")
         << std::setprecision(std::clamp(kCornerDigits + beyond, kCornerDigits, 17)) << x;
  }
  text << "]";
  return text.str();
}

std::string box_text(const Box& box) {
  const double size = diagonal(box);
  return corner_text(box.low, size) + " to " + corner_text(box.high, size);
}

// Of a file's "MM" what people write.
std::string unit_text(std::string unit) {
  for (char& c : unit) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return unit;
}

std::string info_text(const Input& input, const ModelFacts& facts) {
  std::ostringstream text;
  text << input.name << "\n  ";
  const char* before = "";
  for (const auto& [number, one, many] : reports::shape_counts(reports::subject_of(input))) {
    text << before << number << " " << (number == 1 ? one : many);
    before = ", ";
  }
  text << "\n  surfaces:" << (facts.surfaces.empty() ? " none" : "");
  before = " ";
  for (const auto& [word, number] : facts.surfaces) {
    text << before << number << " " << word;
    before = ", ";
  }
  if (facts.box) text << "\n  box (mm): " << box_text(facts.box->box);
  if (facts.box && facts.box->precision > kUsualPrecision) text << ", to " << facts.box->precision;
  text << "\n  tolerances: " << facts.least_tolerance << " to " << facts.largest_tolerance << "\n  "
       << (facts.valid ? "valid" : "NOT VALID") << ", file in "
       << unit_text(input.model.file_unit()) << "\n";
  return text.str();
}

// Faces that are not valid, or all of them.
std::string faces_text(const ModelFacts& facts, bool all) {
  std::string text;
  for (const FaceFacts& face : facts.faces)
    if (all || !face.problems.empty()) text += face_line(face);
  if (text.empty()) return text;
  return "  face  surface    form" + std::string(33, ' ') +
         "area (mm²)  tolerance   validity, colour, name\n" + text;
}

struct InfoCommand {
  std::vector<std::string> inputs;
  bool faces = false, edges = false, tree = false;
  CommonOptions common;
};

bool tells_of_mesh(const Json& report) { return report.at("schema") == "blossom.mesh-info/1"; }

void add_box(const Json& box, std::vector<std::string>& fields) {
  for (std::size_t corner = 0; corner < 2; ++corner)
    for (std::size_t k = 0; k < 3; ++k)
      fields.push_back(box.is_null() ? "" : box[corner][k].dump());
}

// Of triangles what they have: parts are shells, and groups faces.
std::vector<std::string> mesh_fields(const Json& report) {
  std::vector<std::string> fields = {
      "", report.at("parts").dump(),  std::to_string(report.at("groups").size()),
      "", report.at("points").dump(), ""};
  add_box(report.at("box"), fields);
  fields.insert(fields.end(), {"", report.at("closed").get<bool>() ? "closed" : "not closed"});
  return fields;
}

std::vector<std::string> info_fields(const Json& report) {
  if (tells_of_mesh(report)) return mesh_fields(report);
  std::vector<std::string> fields;
  for (const char* kind : {"solids", "shells", "faces", "edges", "vertices"})
    fields.push_back(report.at("counts").at(kind).dump());
  fields.push_back(report.at("file_unit").get<std::string>());
  add_box(report.at("box"), fields);
  fields.push_back(report.at("tolerance").at("largest").dump());
  fields.emplace_back(report.at("valid").get<bool>() ? "valid" : "not valid");
  return fields;
}

std::string info_words(const Json& report) {
  if (tells_of_mesh(report))
    return counted(report.at("triangles").get<std::size_t>(), "triangle") + ", " +
           counted(report.at("parts").get<std::size_t>(), "part") + ", " +
           (report.at("closed").get<bool>() ? "closed" : "not closed");
  const auto count = [&](const char* kind) {
    return report.at("counts").at(kind).get<std::size_t>();
  };
  return counted(count("solids"), "solid") + ", " + counted(count("faces"), "face") + ", " +
         counted(count("edges"), "edge") + ", " +
         (report.at("valid").get<bool>() ? "valid" : "NOT VALID");
}

int run_on_many(const CLI::App& command, const InfoCommand& options) {
  return run_many({&command,
                   options.inputs,
                   options.common,
                   {"solids", "shells", "faces", "edges", "vertices", "unit", "x_min", "y_min",
                    "z_min", "x_max", "y_max", "z_max", "largest_tolerance", "validity"},
                   info_fields,
                   info_words});
}

int run(const InfoCommand& options) {
  const std::string& first = options.inputs.front();
  if (is_mesh_input(first) && (options.edges || options.tree))
    throw UsageError(first + ": is of triangles, which have no --edges and no --tree");
  if (is_mesh_input(first))
    return run_mesh_info(first, options.faces || verbosity() == Verbosity::Verbose, options.common);
  check_files(options.common, options.inputs);
  const bool listed = options.faces || verbosity() == Verbosity::Verbose;
  reading_policy().looks = reading_policy().looks || listed;
  const Input input =
      read_input(first, Faces::Optional, reports::Repairing::None,
                 options.edges ? reports::LooseFaces::Sewn : reports::LooseFaces::Kept);
  occt::KeptForms forms;
  const auto problems =
      occt::face_problems(input.faces, input.numbers, watched_checks(input.model.file()), &forms);
  const ModelFacts facts = reports::model_facts(
      input, problems, listed ? reports::FaceDetail::Full : reports::FaceDetail::Brief, interrupted,
      &forms);
  stop_if_interrupted();
  const std::vector<PictureFile> pictures =
      picture_files(options.common, [&] { return pictures::model_picture(input, facts); });
  stop_if_interrupted();
  write_pictures(pictures);
  const std::string& json = options.common.json;
  Json report = reports::info_report(input, facts);
  std::string text = info_text(input, facts) + faces_text(facts, listed);
  if (options.edges) {
    const EdgeList edges = edge_list(input);
    report["edges"] = edges.json;
    text += edges.text;
  }
  if (options.tree) {
    const TreeList tree = tree_list(input.model);
    report["tree"] = tree.json;
    text += tree.text;
  }
  if (!json.empty()) write_json(report, json);
  print_summary(text, json);
  return kExitComplete;
}

}  // namespace

void add_info(CLI::App& app, int& exit_code) {
  CLI::App* const command = app.add_subcommand(
      "info", "what a model has: solids, faces, surfaces, size, unit, validity; parts and edges");
  const auto options = std::make_shared<InfoCommand>();
  command
      ->add_option(
          "input", options->inputs,
          "model, or some of its faces; or triangles, as .stl, .ply, .obj or .off; or many of "
          "them")
      ->required()
      ->type_name("FILE");
  command->add_flag(
      "--faces", options->faces,
      "list all faces, not only those that are not valid: number, surface, radius or "
      "degrees, area, tolerance, colour; -v their axes and parameters, too; of triangles "
      "the groups");
  command->add_flag("--tree", options->tree,
                    "list parts and assemblies, too: names, numbers of solids and faces");
  command->add_flag("--edges", options->edges,
                    "list the edges, too: faces, kind, angle, length, middle");
  add_table(*command, options->common, "each model");
  add_common_options(*command, options->common, "");
  command->callback([options, command, &exit_code] {
    exit_code = are_many(options->inputs, options->common) ? run_on_many(*command, *options)
                                                           : run(*options);
  });
}

}  // namespace blossom::cli
