// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom blend KIND ...`: surfaces between surfaces.

#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <string>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "adapters/occt/strip.h"
#include "plugin/cli/commands/blend_fill.h"
#include "plugin/cli/commands/blend_parts.h"
#include "plugin/cli/commands/commands.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/inputs.h"
#include "plugin/cli/interruption.h"
#include "plugin/cli/options.h"
#include "plugin/cli/output.h"
#include "plugin/cli/picture/files.h"
#include "plugin/cli/values.h"
#include "plugin/reports/strip.h"

namespace blossom::cli {
namespace {

const std::map<std::string, SurfaceSide> kSides = {{"umin", SurfaceSide::UMin},
                                                   {"umax", SurfaceSide::UMax},
                                                   {"vmin", SurfaceSide::VMin},
                                                   {"vmax", SurfaceSide::VMax}};

struct StripCommand {
  std::string a;
  std::string b;
  std::string edge_a;  ///< empty: the nearest
  std::string edge_b;
  double weight_a = StripOptions{}.weight_a;
  double weight_b = StripOptions{}.weight_b;
  CommonOptions common;
};

Input read_one_face(const std::string& text) {
  Input input = read_input(text);
  if (input.faces.size() != 1)
    throw UsageError(text + ": a strip starts from one face, these are " +
                     std::to_string(input.faces.size()) + "; name one, as in " +
                     input.model.file().string() + "#1");
  return input;
}

std::optional<SurfaceSide> side_of(const std::string& word) {
  if (word.empty()) return std::nullopt;
  return kSides.at(word);
}

struct TimedStrip {
  occt::FaceStrip made;
  double seconds = 0;
};

TimedStrip timed_strip(const Input& a, const Input& b, const StripCommand& command) {
  const auto start = std::chrono::steady_clock::now();
  TimedStrip timed;
  timed.made =
      occt::strip_between(a.faces.front(), b.faces.front(),
                          {.side_a = side_of(command.edge_a),
                           .side_b = side_of(command.edge_b),
                           .strip = {.weight_a = command.weight_a, .weight_b = command.weight_b}});
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  timed.seconds = took.count();
  return timed;
}

std::string summary(const Input& a, const Input& b, const TimedStrip& timed) {
  const occt::FaceStrip& made = timed.made;
  const StripContact worst = reports::worst_of(made.strip);
  std::ostringstream text;
  text << "strip from " << a.name << " " << to_string(made.side_a) << " to " << b.name << " "
       << to_string(made.side_b) << (made.strip.backward ? " (backwards)" : "") << ": degree "
       << made.surface->UDegree() << " x " << made.surface->VDegree() << ", "
       << counted(static_cast<std::size_t>(made.surface->NbUKnots() - 1), "span")
       << "\n  largest gap " << worst.gap << ", largest angle between normals "
       << worst.normal_angle << " rad, " << timed.seconds << " s\n";
  return text.str();
}

void write_outputs(const Input& a, const Input& b, const StripCommand& command,
                   const TimedStrip& timed) {
  if (!command.common.output.empty()) {
    occt::Model model;
    model.add(timed.made.face, "strip");
    write_model(model, command.common.output);
  }
  write_pictures(picture_files(command.common, [&] {
    Picture picture;
    picture.title = "strip from " + short_name(a.name) + " to " + short_name(b.name);
    picture.groups = {{a.faces, kFirstColour, 1, short_name(a.name)},
                      {b.faces, kFirstColour, 1, short_name(b.name)},
                      {{timed.made.face}, kSecondColour, 1, "strip"}};
    return picture;
  }));
  if (!command.common.json.empty())
    write_json(
        reports::strip_report(a, b, {.weight_a = command.weight_a, .weight_b = command.weight_b},
                              timed.made, timed.seconds),
        command.common.json);
  print_summary(summary(a, b, timed), command.common.json);
}

int run(const StripCommand& command) {
  check_files(command.common, {command.a, command.b});
  const Input a = read_one_face(command.a);
  const Input b = read_one_face(command.b);
  stop_if_interrupted();
  const TimedStrip timed = timed_strip(a, b, command);
  stop_if_interrupted();
  write_outputs(a, b, command, timed);
  return kExitComplete;
}

void add_strip(CLI::App& blend, int& exit_code) {
  CLI::App* const command = blend.add_subcommand(
      "strip", "a strip between two faces that continues both with their tangent planes, exactly");
  const auto options = std::make_shared<StripCommand>();
  command->add_option("a", options->a, "face, as A#3 or a model of one")
      ->required()
      ->type_name("A");
  command->add_option("b", options->b, "likewise")->required()->type_name("B");
  for (const auto& [name, edge] :
       {std::pair{"--edge-a", &options->edge_a}, {"--edge-b", &options->edge_b}})
    limit_to(*command->add_option(name, *edge, "border of the face; the nearest when not given"),
             {"umin", "umax", "vmin", "vmax"});
  for (const auto& [name, weight] :
       {std::pair{"--weight-a", &options->weight_a}, {"--weight-b", &options->weight_b}})
    command->add_option(name, *weight, "how far the face's tangents reach into the strip")
        ->check(positive_number())
        ->type_name("X")
        ->capture_default_str();
  add_common_options(*command, options->common, "write the strip (.step, .brep, .iges)");
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace

void add_blend(CLI::App& app, int& exit_code) {
  CLI::App* const blend = app.add_subcommand("blend", "surfaces between surfaces");
  blend->require_subcommand(1);
  add_strip(*blend, exit_code);
  add_blend_fill(*blend, exit_code);
  add_blend_fillet(*blend, exit_code);
  add_blend_chamfer(*blend, exit_code);
}

}  // namespace blossom::cli
