// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom blend KIND ...`: surfaces between surfaces.

#include <chrono>
#include <memory>
#include <sstream>
#include <string>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "plugin/cli/arguments/inputs.h"
#include "plugin/cli/arguments/options.h"
#include "plugin/cli/arguments/values.h"
#include "plugin/cli/commands/blend/blend_fill.h"
#include "plugin/cli/commands/blend/blend_parts.h"
#include "plugin/cli/commands/commands.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/output/output.h"
#include "plugin/cli/picture/files.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/pictures/results/blends.h"
#include "plugin/reports/blends/strip.h"
#include "plugin/reports/models/entity_words.h"

namespace blossom::cli {
namespace {

struct StripCommand {
  std::string a;
  std::string b;
  reports::StripWishes wishes;
  std::string continuity = "G1";
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

struct TimedStrip {
  occt::FaceStrip made;
  double seconds = 0;
};

TimedStrip timed_strip(const Input& a, const Input& b, const StripCommand& command) {
  const auto start = std::chrono::steady_clock::now();
  TimedStrip timed;
  timed.made = reports::strip_between(a, b, command.wishes);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  timed.seconds = took.count();
  return timed;
}

/// What could not be taken from the face's own control points.
void report_fit(std::ostream& text, const Input& input, const occt::FaceStripEnd& end) {
  if (!end.exact)
    text << "  " << input.name << ' ' << reports::start_text(input.shape, end.start)
         << " is followed by polynomials within " << rounded(end.fit_error) << '\n';
}

std::string summary(const Input& a, const Input& b, const TimedStrip& timed, int order) {
  const occt::FaceStrip& made = timed.made;
  const StripContact worst = reports::worst_of(made.strip);
  std::ostringstream text;
  text << "strip from " << a.name << ' ' << reports::start_text(a.shape, made.ends[0].start)
       << " to " << b.name << ' ' << reports::start_text(b.shape, made.ends[1].start)
       << (made.strip.backward ? " (backwards)" : "") << ": G" << order << ", degree "
       << made.surface->UDegree() << " x " << made.surface->VDegree() << ", "
       << counted(static_cast<std::size_t>(made.surface->NbUKnots() - 1), "span")
       << "\n  largest gap " << rounded(worst.gap) << ", largest angle between normals "
       << rounded(worst.normal_angle) << " rad";
  if (order > 1) text << ", difference of curvatures " << rounded(worst.curvature);
  text << ", " << seconds_text(timed.seconds) << "\n";
  report_fit(text, a, made.ends[0]);
  report_fit(text, b, made.ends[1]);
  return text.str();
}

void write_outputs(const Input& a, const Input& b, const StripCommand& command,
                   const TimedStrip& timed) {
  if (!command.common.output.empty()) {
    occt::Model model;
    model.add(timed.made.face, "strip");
    write_model(model, command.common.output);
  }
  write_pictures(
      picture_files(command.common, [&] { return pictures::strip_picture(a, b, timed.made); }));
  if (!command.common.json.empty())
    write_json(reports::strip_report(a, b, command.wishes, timed.made, timed.seconds),
               command.common.json);
  print_summary(summary(a, b, timed, command.wishes.strip.order), command.common.json);
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

/// Words of `strip_start`, checked where a typing error is still one of usage.
CLI::Validator border_word() {
  return {[](const std::string& word) -> std::string {
            for (const char* const side : {"umin", "umax", "vmin", "vmax"})
              if (word == side) return {};
            return reports::entity_number(word, "edge")
                       ? ""
                       : "takes umin, umax, vmin, vmax or the number of an edge, not '" + word +
                             "'";
          },
          "", "border"};
}

void add_strip(CLI::App& blend, int& exit_code) {
  CLI::App* const command = blend.add_subcommand(
      "strip", "a strip between two faces that continues both, exactly or as near as is said");
  const auto options = std::make_shared<StripCommand>();
  command->add_option("a", options->a, "face, as A#3 or a model of one")
      ->required()
      ->type_name("A");
  command->add_option("b", options->b, "likewise")->required()->type_name("B");
  reports::StripWishes& wishes = options->wishes;
  for (const auto& [name, border] :
       {std::pair{"--edge-a", &wishes.border_a}, {"--edge-b", &wishes.border_b}})
    command
        ->add_option(name, *border,
                     "border of the face: umin, umax, vmin, vmax, or the number of an edge as in "
                     "'info --edges'; the nearest when not given")
        ->check(border_word())
        ->type_name("BORDER");
  limit_to(*command->add_option("--continuity", options->continuity,
                                "what the strip continues: tangent planes (G1), curvatures (G2), "
                                "or their derivatives too (G3)"),
           {"G1", "G2", "G3"});
  for (const auto& [name, weight] :
       {std::pair{"--weight-a", &wishes.strip.weight_a}, {"--weight-b", &wishes.strip.weight_b}})
    command->add_option(name, *weight, "how far the face's tangents reach into the strip")
        ->check(positive_number())
        ->type_name("X")
        ->capture_default_str();
  add_common_options(*command, options->common, "write the strip (.step, .brep, .iges)");
  command->callback([options, &exit_code] {
    options->wishes.strip.order = options->continuity[1] - '0';
    exit_code = run(*options);
  });
}

}  // namespace

void add_blend(CLI::App& app, int& exit_code) {
  CLI::App* const blend =
      app.add_subcommand("blend", "rounds and cuts off edges, fills holes, joins faces by strips");
  blend->require_subcommand(1);
  add_strip(*blend, exit_code);
  add_blend_fill(*blend, exit_code);
  add_blend_fillet(*blend, exit_code);
  add_blend_chamfer(*blend, exit_code);
}

}  // namespace blossom::cli
