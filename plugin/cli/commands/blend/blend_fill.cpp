// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/commands/blend/blend_fill.h"

#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "plugin/cli/arguments/inputs.h"
#include "plugin/cli/arguments/options.h"
#include "plugin/cli/arguments/values.h"
#include "plugin/cli/commands/meshes/fill_of_mesh.h"
#include "plugin/cli/commands/meshes/meshed_input.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/output/output.h"
#include "plugin/cli/output/reading.h"
#include "plugin/cli/picture/files.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/pictures/results/blends.h"
#include "plugin/reports/blends/fill.h"
#include "plugin/reports/models/entity_words.h"

namespace blossom::cli {
namespace {

struct FillCommand {
  std::string model;
  std::string edges;  ///< as "3,7,9"; empty: all that are open
  std::string continuity = "G1";
  std::string layout = "auto";
  double tolerance = Tolerances{}.point;
  double angle = FillOptions{}.angle;
  bool sew = false;
  CommonOptions common;
};

std::vector<std::string> parts_of(const std::string& list) {
  std::vector<std::string> parts;
  std::stringstream text(list);
  for (std::string part; std::getline(text, part, ',');) parts.push_back(part);
  return parts;
}

std::vector<int> edges_of(const std::string& list) {
  std::vector<int> edges;
  for (const std::string& part : parts_of(list)) {
    const auto range = reports::entity_range(part, "edge");
    if (!range) throw UsageError("--edges takes numbers of edges, as 3,7-9, not '" + part + "'");
    for (int edge = range->first; edge <= range->last; ++edge) edges.push_back(edge);
  }
  return edges;
}

FillContinuity continuity_of(const std::string& word) {
  for (const FillContinuity known : {FillContinuity::G0, FillContinuity::G1, FillContinuity::G2})
    if (word == to_string(known)) return known;
  throw UsageError("--continuity takes G0, G1 or G2, one for all edges or one for each, not '" +
                   word + "'");
}

occt::HoleOptions options_of(const FillCommand& command) {
  occt::HoleOptions options;
  options.fill.tolerances.point = command.tolerance;
  options.fill.angle = command.angle;
  for (const FillLayout layout : {FillLayout::Star, FillLayout::Ring, FillLayout::DeepRing})
    if (command.layout == (layout == FillLayout::DeepRing ? "deep-ring" : to_string(layout)))
      options.fill.layout = layout;
  return options;
}

reports::FillWishes wishes_of(const FillCommand& command) {
  reports::FillWishes wishes{.edges = edges_of(command.edges),
                             .continuity = {},
                             .options = options_of(command),
                             .sew_gap = reading_policy().sew};
  for (const std::string& word : parts_of(command.continuity))
    wishes.continuity.push_back(continuity_of(word));
  const std::size_t words = wishes.continuity.size();
  if (words != 1 && words != wishes.edges.size())
    throw UsageError("--continuity has " + counted(words, "word") + " for " +
                     counted(wishes.edges.size(), "edge") + " of --edges");
  return wishes;
}

std::string summary(const Input& input, const reports::FillAnswer& holes) {
  std::ostringstream text;
  text << "filled " << counted(holes.filled(), "hole") << " of " << input.name << ", "
       << seconds_text(holes.seconds) << "\n";
  for (const reports::Hole& hole : holes.all) {
    if (hole.loop.empty()) {
      text << "  left out: " << hole.message << '\n';
      continue;
    }
    text << "  edges";
    for (const occt::HoleEdge& edge : hole.loop) text << ' ' << edge.number;
    if (!hole.reason.empty()) {
      text << ": not filled, " << hole.message << '\n';
      continue;
    }
    const Fill& fill = hole.filled.fill;
    const FillContact worst = reports::worst_of(fill);
    text << ": ";
    if (hole.filled.flat)
      text << "a flat face, ";
    else
      text << to_string(fill.layout) << ", " << fill.patches.size() << " patches of degree "
           << fill.degree << ", ";
    text << to_string(fill.reached) << "\n    largest gap " << rounded(worst.gap)
         << ", angle between normals " << rounded(worst.normal_angle)
         << " rad, difference of curvatures " << rounded(worst.curvature_difference) << " of "
         << rounded(fill.figures.largest_curvature) << '\n';
    for (const occt::FilledSide& side : hole.filled.sides)
      if (!side.exact)
        text << "    the neighbour at edge " << side.edge.number << " was fitted within "
             << rounded(side.error) << ", " << rounded(side.angle_error) << " rad\n";
  }
  for (const occt::HoleLoop& loop : holes.sheets) {
    text << "  edges";
    for (const occt::HoleEdge& edge : loop) text << ' ' << edge.number;
    text << ": the outer border of a sheet, no hole\n";
  }
  return text.str();
}

void write_outputs(const Input& input, const FillCommand& command,
                   const reports::FillAnswer& holes) {
  if (!command.common.output.empty()) {
    const double tolerance = command.tolerance;
    write_model(command.sew ? reports::filled_model(input, holes, tolerance, stop_if_interrupted)
                            : reports::fills_alone(holes, tolerance),
                command.common.output);
  }
  write_pictures(
      picture_files(command.common, [&] { return pictures::fill_picture(input, holes); }));
  if (!command.common.json.empty())
    write_json(reports::fill_report(input, holes), command.common.json);
  print_summary(summary(input, holes), command.common.json);
}

/// Less than was asked for is not complete: a hole that stays, or curvatures that do not agree.
int code_of(const reports::FillAnswer& holes) {
  return reports::is_as_asked(holes) ? kExitComplete : kExitTolerance;
}

int run(const FillCommand& command) {
  if (is_mesh_input(command.model)) {
    refuse_options(command.common,
                   {"--edges", "--sew", "--layout", "--continuity", "--tolerance", "--angle"},
                   "of triangles all holes are filled");
    return run_fill_of_mesh(command.model, command.common);
  }
  const reports::FillWishes wishes = wishes_of(command);
  check_files(command.common, {command.model});
  const Input input = read_input(command.model);
  stop_if_interrupted();
  const reports::FillAnswer holes = reports::fill_holes(input, wishes, stop_if_interrupted);
  stop_if_interrupted();
  write_outputs(input, command, holes);
  return code_of(holes);
}

}  // namespace

void add_blend_fill(CLI::App& blend, int& exit_code) {
  CLI::App* const command = blend.add_subcommand(
      "fill",
      "patches in holes of 3 to 12 sides that continue their neighbours, exactly; flat faces in "
      "round holes");
  const auto options = std::make_shared<FillCommand>();
  command
      ->add_option("model", options->model,
                   "model with the hole, or a mesh (.stl, .ply, .obj, .off)")
      ->required()
      ->type_name("A");
  command
      ->add_option("--edges,--edge", options->edges,
                   "edges round the hole by number, in any order; all open ones when not given")
      ->type_name("N,N,...");
  command
      ->add_option("--continuity", options->continuity,
                   "G0, G1 or G2; one for all edges, or one for each of --edges")
      ->type_name("WORD,...")
      ->capture_default_str();
  limit_to(*command->add_option("--layout", options->layout, "layout of the patches")
                ->capture_default_str(),
           {"auto", "star", "ring", "deep-ring"});
  command
      ->add_option("--tolerance", options->tolerance,
                   "distance of corners that join, and of neighbours that have to be fitted")
      ->check(positive_number())
      ->type_name("X")
      ->capture_default_str();
  add_angle(*command, "--angle", options->angle, "angle between normals that counts as smooth");
  command->add_flag("--sew", options->sew, "write the model with the fill joined to it");
  add_common_options(
      *command, options->common,
      "write the fill (.step, .brep, .iges), or the filled mesh (.stl, .ply, .obj, .off)");
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace blossom::cli
