// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/commands/blend_fill.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <memory>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/blending/hole.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/inputs.h"
#include "plugin/cli/interruption.h"
#include "plugin/cli/options.h"
#include "plugin/cli/output.h"
#include "plugin/cli/picture/picture.h"
#include "plugin/cli/values.h"
#include "plugin/reports/repairs.h"

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
    int number = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), number);
    if (error != std::errc() || end != part.data() + part.size())
      throw UsageError("--edges takes numbers of edges, as 3,7,9, not '" + part + "'");
    edges.push_back(number);
  }
  return edges;
}

FillContinuity continuity_of(const std::string& word) {
  for (const FillContinuity known : {FillContinuity::G0, FillContinuity::G1, FillContinuity::G2})
    if (word == to_string(known)) return known;
  throw UsageError("--continuity takes G0, G1 or G2, one for all edges or one for each, not '" +
                   word + "'");
}

/// The command's lists, taken apart.
struct Wishes {
  std::vector<int> edges;
  std::vector<FillContinuity> continuity;  ///< one, or one for each edge
};

/// What is asked of an edge: its own word, else the one for all, which an edge without a neighbour
/// takes as G0.
FillContinuity asked_of(const Wishes& wishes, const occt::HoleEdge& edge) {
  if (wishes.continuity.size() == 1)
    return edge.face.IsNull() ? FillContinuity::G0 : wishes.continuity.front();
  const auto at = std::find(wishes.edges.begin(), wishes.edges.end(), edge.number);
  return wishes.continuity[static_cast<std::size_t>(at - wishes.edges.begin())];
}

Wishes wishes_of(const FillCommand& command) {
  Wishes wishes{.edges = edges_of(command.edges), .continuity = {}};
  for (const std::string& word : parts_of(command.continuity))
    wishes.continuity.push_back(continuity_of(word));
  const std::size_t words = wishes.continuity.size();
  if (words != 1 && words != wishes.edges.size())
    throw UsageError("--continuity has " + counted(words, "word") + " for " +
                     counted(wishes.edges.size(), "edge") + " of --edges");
  return wishes;
}

/// A hole and the reason why it was not filled, if there is one.
struct Hole {
  occt::HoleLoop loop;
  occt::FilledHole filled;
  std::string reason;  ///< a word of the report
  std::string message;
};

struct Holes {
  std::vector<Hole> all;
  double seconds = 0;

  std::size_t filled() const {
    return static_cast<std::size_t>(std::count_if(
        all.begin(), all.end(), [](const Hole& hole) { return hole.reason.empty(); }));
  }
};

occt::HoleOptions options_of(const FillCommand& command) {
  occt::HoleOptions options;
  options.fill.tolerances.point = command.tolerance;
  options.fill.angle = command.angle;
  for (const FillLayout layout : {FillLayout::Star, FillLayout::Ring, FillLayout::DeepRing})
    if (command.layout == (layout == FillLayout::DeepRing ? "deep-ring" : to_string(layout)))
      options.fill.layout = layout;
  return options;
}

Hole filled(const FillCommand& command, const Wishes& wishes, occt::HoleLoop loop) {
  Hole hole{.loop = std::move(loop), .filled = {}, .reason = {}, .message = {}};
  std::vector<FillContinuity> continuity;
  for (const occt::HoleEdge& edge : hole.loop) continuity.push_back(asked_of(wishes, edge));
  try {
    hole.filled = occt::filled_hole(hole.loop, continuity, options_of(command));
    if (hole.filled.fill.problem != FillProblem::None) {
      hole.reason = to_string(hole.filled.fill.problem);
      hole.message = hole.filled.fill.message;
    }
  } catch (const occt::BadModel& error) {
    hole.reason = "edges";
    hole.message = error.what();
  }
  return hole;
}

/// Edges that were named have to be filled all; of all open ones those that can be.
Holes all_holes(const FillCommand& command, const Wishes& wishes, const Input& input) {
  const auto start = std::chrono::steady_clock::now();
  const TopoDS_Shape& model = input.model.shape();
  const bool named = !wishes.edges.empty();
  const occt::OpenLoops found =
      named ? occt::OpenLoops{occt::hole_loops(model, wishes.edges), {}} : occt::open_loops(model);
  Holes holes;
  for (const occt::HoleLoop& loop : found.loops) {
    stop_if_interrupted();
    holes.all.push_back(filled(command, wishes, loop));
    if (named && !holes.all.back().reason.empty())
      throw occt::BadModel(input.name + ": " + holes.all.back().message);
  }
  for (const std::string& message : found.left_out)
    holes.all.push_back({.loop = {}, .filled = {}, .reason = "edges", .message = message});
  if (holes.all.empty()) throw occt::BadModel(input.name + " has no open edge, so no hole");
  if (holes.filled() == 0) throw occt::BadModel(input.name + ": " + holes.all.front().message);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  holes.seconds = took.count();
  return holes;
}

/// Worst figures over sides and inner edges.
FillContact worst_of(const Fill& fill) {
  FillContact worst = fill.figures.inside;
  for (const FillContact& side : fill.figures.sides) {
    worst.gap = std::max(worst.gap, side.gap);
    worst.normal_angle = std::max(worst.normal_angle, side.normal_angle);
    worst.curvature_difference = std::max(worst.curvature_difference, side.curvature_difference);
  }
  return worst;
}

Json contact_json(const FillContact& contact) {
  return {{"gap", contact.gap},
          {"normal_angle", contact.normal_angle},
          {"curvature_difference", contact.curvature_difference}};
}

Json edges_json(const occt::HoleLoop& loop) {
  Json edges = Json::array();
  for (const occt::HoleEdge& edge : loop) edges.push_back(edge.number);
  return edges;
}

Json hole_json(const Hole& hole) {
  const Fill& fill = hole.filled.fill;
  Json sides = Json::array();
  for (std::size_t k = 0; k < hole.filled.sides.size(); ++k) {
    const occt::FilledSide& side = hole.filled.sides[k];
    Json json{{"edge", side.edge.number},
              {"asked", to_string(side.continuity)},
              {"exact", side.exact},
              {"fit_error", side.error},
              {"fit_angle", side.angle_error}};
    json.update(contact_json(fill.figures.sides[k]));
    sides.push_back(std::move(json));
  }
  return {{"edges", edges_json(hole.loop)},
          {"layout", to_string(fill.layout)},
          {"patches", fill.patches.size()},
          {"degree", fill.degree},
          {"rational", fill.rational},
          {"reached", to_string(fill.reached)},
          {"largest_curvature", fill.figures.largest_curvature},
          {"residual", fill.residual},
          {"least_weight", fill.least_weight},
          {"inside", contact_json(fill.figures.inside)},
          {"sides", std::move(sides)}};
}

Json report_of(const Input& input, const Holes& holes) {
  Json filled = Json::array(), refused = Json::array();
  for (const Hole& hole : holes.all)
    if (hole.reason.empty())
      filled.push_back(hole_json(hole));
    else
      refused.push_back(
          {{"edges", edges_json(hole.loop)}, {"reason", hole.reason}, {"message", hole.message}});
  return {{"schema", "blossom.blend/1"},
          {"kind", "fill"},
          {"file", input.name},
          {"holes", std::move(filled)},
          {"refused", std::move(refused)},
          {"seconds", holes.seconds},
          {"repairs", Json::array({repairs_json(input)})}};
}

std::string summary(const Input& input, const Holes& holes) {
  std::ostringstream text;
  text << "filled " << counted(holes.filled(), "hole") << " of " << input.name << ", "
       << rounded(holes.seconds) << " s\n";
  for (const Hole& hole : holes.all) {
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
    const FillContact worst = worst_of(fill);
    text << ": " << to_string(fill.layout) << ", " << fill.patches.size() << " patches of degree "
         << fill.degree << ", " << to_string(fill.reached) << "\n    largest gap "
         << rounded(worst.gap) << ", angle between normals " << rounded(worst.normal_angle)
         << " rad, difference of curvatures " << rounded(worst.curvature_difference) << " of "
         << rounded(fill.figures.largest_curvature) << '\n';
    for (const occt::FilledSide& side : hole.filled.sides)
      if (!side.exact)
        text << "    the neighbour at edge " << side.edge.number << " was fitted within "
             << rounded(side.error) << ", " << rounded(side.angle_error) << " rad\n";
  }
  return text.str();
}

void write_outputs(const Input& input, const FillCommand& command, const Holes& holes) {
  std::vector<occt::FilledHole> filled;
  std::vector<TopoDS_Face> faces;
  for (const Hole& hole : holes.all)
    if (hole.reason.empty()) {
      filled.push_back(hole.filled);
      faces.insert(faces.end(), hole.filled.faces.begin(), hole.filled.faces.end());
    }
  if (!command.common.output.empty()) {
    occt::Model model;
    model.add(occt::sewn_holes(filled, command.sew ? input.model.shape() : TopoDS_Shape(),
                               std::max(command.tolerance, Tolerances{}.point)),
              command.sew ? "filled" : "fill");
    write_model(model, command.common.output);
  }
  if (!command.common.picture.empty()) {
    Picture picture;
    picture.groups = {{input.faces, kFirstColour}, {faces, kSecondColour}};
    occt::write_text(picture_png(picture), command.common.picture);
  }
  if (!command.common.json.empty()) write_json(report_of(input, holes), command.common.json);
  print_summary(summary(input, holes), command.common.json);
}

/// Less than was asked for is not complete: a hole that stays, or curvatures that do not agree.
int code_of(const Holes& holes) {
  bool all_reached = true;
  for (const Hole& hole : holes.all) {
    if (!hole.reason.empty()) return kExitStopped;
    for (const occt::FilledSide& side : hole.filled.sides)
      all_reached = all_reached && side.continuity <= hole.filled.fill.reached;
  }
  return all_reached ? kExitComplete : kExitTolerance;
}

int run(const FillCommand& command) {
  const Wishes wishes = wishes_of(command);
  check_files(command.common, {command.model});
  const Input input = read_input(command.model);
  stop_if_interrupted();
  const Holes holes = all_holes(command, wishes, input);
  stop_if_interrupted();
  write_outputs(input, command, holes);
  return code_of(holes);
}

}  // namespace

void add_blend_fill(CLI::App& blend, int& exit_code) {
  CLI::App* const command = blend.add_subcommand(
      "fill", "patches in holes of 3 to 12 sides that continue their neighbours, exactly");
  const auto options = std::make_shared<FillCommand>();
  command->add_option("model", options->model, "model with the hole")->required()->type_name("A");
  command
      ->add_option("--edges", options->edges,
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
  command
      ->add_option("--angle", options->angle,
                   "angle between normals that counts as smooth, radians")
      ->check(positive_number())
      ->type_name("X")
      ->capture_default_str();
  command->add_flag("--sew", options->sew, "write the model with the fill joined to it");
  add_common_options(*command, options->common, "write the fill (.step, .brep, .iges)");
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace blossom::cli
