// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom blend fillet PART` and `blossom blend chamfer PART`: edges of solids rounded by a
// rolling ball, or cut off.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/edge_facts.h"
#include "adapters/occt/fillet.h"
#include "adapters/occt/full_round.h"
#include "core/base/errors.h"
#include "plugin/cli/arguments/inputs.h"
#include "plugin/cli/arguments/options.h"
#include "plugin/cli/arguments/values.h"
#include "plugin/cli/commands/blend/blend_parts.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/output/output.h"
#include "plugin/cli/output/reading.h"
#include "plugin/cli/output/verbosity.h"
#include "plugin/cli/picture/files.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/cli/process/progress.h"
#include "plugin/pictures/results/blends.h"
#include "plugin/reports/blends/blend_words.h"
#include "plugin/reports/blends/fillet.h"
#include "plugin/reports/models/entity_words.h"
#include "plugin/reports/models/selection.h"
#include "plugin/reports/text/words.h"

namespace blossom::cli {
namespace {

struct FilletCommand {
  std::string part;
  std::vector<std::string> edge_words;  ///< --edge
  reports::EdgeChoice chosen{};         ///< the same, read
  std::vector<std::string> of_parts{};  ///< of these what needs the model: Bolt/Edge3, Bolt/Edge3:5
  std::string all;                      ///< a kind instead: "all", "convex" or "concave"
  bool has_bare_edge = false;           ///< one of them has no radius of its own
  std::vector<int> between;
  std::string size;              ///< --radius or --distance
  std::string section;           ///< --section
  std::string law;               ///< --law
  std::string setback;           ///< --setback
  occt::FilletOptions fillet{};  ///< both of them, read
  bool partial = false;
  bool full_round = false;

  bool is_chamfer() const { return fillet.chamfer.has_value(); }
  CommonOptions common;
  EngineOptions engine;
};

using TimedFillets = reports::FilletAnswer;

reports::EdgeWish wish_of(const FilletCommand& command) {
  reports::EdgeWish wish{{command.chosen.edges.begin(), command.chosen.edges.end()}, command.all};
  if (!command.between.empty()) wish.between = {command.between[0], command.between[1]};
  return wish;
}

TimedFillets timed_fillet(const FilletCommand& command, const Input& part) {
  Progress progress("filleting");
  TimedFillets timed{.of = command.fillet};
  std::string note;
  timed.asked = reports::edges_asked(wish_of(command), part, note);
  const auto start = std::chrono::steady_clock::now();
  occt::FilletOptions options = command.fillet;
  options.partial = command.partial;
  options.intersection = intersection_options(command.engine, progress);
  timed.made = occt::fillet(part.model.shape(), timed.asked, options);
  if (!note.empty()) timed.made.notes.push_back(note);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  timed.seconds = took.count();
  return timed;
}

void write_part(const Input& part, const TimedFillets& timed, const std::string& file) {
  reports::put_fillets(part.model, timed);
  write_model(part.model, file);
}

// "1, 3-12", as --edges takes them.
std::string edges_text(const std::vector<int>& numbers) {
  std::ostringstream text;
  for (std::size_t i = 0, last = 0; i < numbers.size(); i = last + 1) {
    last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    text << (i == 0 ? "" : ", ") << numbers[i];
    if (last > i) text << (last > i + 1 ? "-" : ", ") << numbers[last];
  }
  return text.str();
}

// "fillet of radius 2, of edge 12 5".
std::string size_text(const FilletCommand& command) {
  std::string text = command.is_chamfer() ? "chamfer of distance " : "fillet ";
  if (!command.is_chamfer() && !command.size.empty())
    text += command.law.empty() ? "of radius " : "by the law ";
  text += command.size;
  bool first = command.size.empty();
  for (const auto& [edge, of] : command.chosen.own) {
    // Those of a full round were computed, the others are told as they were given.
    const auto told = [&](double radius) {
      return number_text(command.full_round ? occt::told_radius(radius) : radius);
    };
    const auto radius_at = [&](double share) { return told(of.law->at(share).value); };
    text += std::string(first ? "of" : ", of") + " edge " + std::to_string(edge) + " by " +
            (of.law ? radius_at(0) + ".." + radius_at(1) : told(of.radius));
    first = false;
  }
  return text;
}

// others   whether the file has parts that are not named: they are in the volume, too
std::string summary(const FilletCommand& command, const Input& part, const TimedFillets& timed,
                    bool others) {
  std::ostringstream text;
  const occt::FilletResult& made = timed.made;
  text << part.name << ": " << size_text(command) << ", ";
  text << reports::done_text(timed) << ", " << seconds_text(timed.seconds) << "\n";
  if (!made.solids.empty()) {
    const double more = reports::volume_of(made) - made.volume_before;
    text << (made.edges.size() == 1 ? "  edge " : "  edges ") << edges_text(made.edges)
         << (others ? "\n  volume of all parts " : "\n  volume ")
         << number_text(rounded(made.volume_before + more)) << " mm³, "
         << number_text(rounded(std::abs(more))) << (more < 0 ? " less" : " more")
         << " than before\n";
  }
  std::vector<std::string> findings = made.notes;
  // Where nothing was made, the first is on stderr.
  const std::size_t told = made.solids.empty() && !reports::is_unchanged(made) ? 1 : 0;
  for (std::size_t i = told; i < made.refused.size(); ++i)
    findings.push_back(made.refused[i].text());
  if (verbosity() != Verbosity::Verbose) findings = reports::by_kind(findings);
  for (const std::string& finding : findings) text << "  " << finding << "\n";
  return text.str();
}

void check_options(const FilletCommand& command) {
  if (command.edge_words.empty() && command.all.empty() && command.between.empty())
    throw UsageError(
        "blend needs edges: --edges N,N, --edges all or --between A,B; "
        "info --edges lists them");
  if (!command.between.empty() && command.between.size() != 2)
    throw UsageError("--between takes two face numbers, as in --between 2,5");
}

// What is wrong with a size is wrong with the usage.
template <class Read>
void read_size(const std::string& option, const Read& read) {
  try {
    read();
  } catch (const InvalidInput& wrong) {
    throw UsageError(option + ": " + wrong.what());
  }
}

// The edges of parts by their numbers in the model.
void choose_edges_of_parts(FilletCommand& command, const Input& part) {
  for (const std::string& word : command.of_parts) {
    const std::size_t radius = word.find(':', word.rfind('/'));
    const std::string own = radius == std::string::npos ? "" : word.substr(radius);
    for (const int edge : reports::selection_of(part.model, {word.substr(0, radius)}).edges)
      read_size("--edges",
                [&] { reports::choose_edges(std::to_string(edge) + own, command.chosen); });
  }
  command.fillet.own = command.chosen.own;
}

// The radii that leave nothing of the face between both edges.
void choose_full_round(FilletCommand& command, const Input& part) {
  if (!command.full_round) return;
  std::string note;
  command.fillet.own =
      reports::full_round_of(part, reports::edges_asked(wish_of(command), part, note));
  command.chosen.own = command.fillet.own;
}

int run(FilletCommand command) {
  check_options(command);
  check_files(command.common, {command.part});
  const Input part = read_input(command.part);
  if (!is_of_solids(part))
    throw UsageError(command.part + ": " + (command.is_chamfer() ? "chamfers" : "fillets") +
                     " are made in whole models and parts, not in some faces");
  choose_edges_of_parts(command, part);
  choose_full_round(command, part);
  stop_if_interrupted();
  TimedFillets timed = timed_fillet(command, part);
  stop_if_interrupted();
  const CommonOptions& outputs = command.common;
  const bool unchanged = reports::is_unchanged(timed.made);
  const bool any = unchanged || !timed.made.solids.empty();
  const bool write = any && !outputs.output.empty();
  const std::string others = other_parts_text(part, OtherParts::Kept);
  if (any)
    write_pictures(picture_files(outputs, [&] { return pictures::fillet_picture(part, timed); }));
  if (write) write_part(part, timed, outputs.output);
  timed.written = write;
  if (!any) {
    const std::string reason =
        timed.made.refused.empty() ? "no edge was changed" : timed.made.refused.front().text();
    std::vector<std::string> files = picture_names(outputs);
    if (!outputs.output.empty()) files.insert(files.begin(), outputs.output);
    for (const std::string& file : files) report_unwritten(file, reason);
    if (files.empty())
      std::cerr << "blossom: there is no " << (command.is_chamfer() ? "chamfer: " : "fillet: ")
                << reason << '\n';
  }
  if (!outputs.json.empty()) write_json(reports::fillet_report(part, timed), outputs.json);
  print_summary(summary(command, part, timed, !others.empty()) + (write ? others : ""),
                outputs.json);
  if (!any) return exit_code_unwritten(exit_code(timed.made.status));
  return stated_exit_code(timed.made.refused.empty() ? exit_code(timed.made.status)
                                                     : kExitTolerance);
}

// Writes "Face3" as the number that it means.
CLI::Validator face_word() {
  return {[](std::string& word) -> std::string {
            if (const auto number = reports::entity_number(word, "face"))
              word = std::to_string(*number);
            return {};
          },
          "", "face"};
}

// What both commands have in common.
CLI::App* add_edges_command(CLI::App& blend, const char* name, const char* about,
                            const char* about_edges,
                            const std::shared_ptr<FilletCommand>& options) {
  CLI::App* const command = blend.add_subcommand(name, about);
  command->add_option("part", options->part, "model of solids")->required()->type_name("PART");
  command
      ->add_option("--edges,--edge", options->edge_words,
                   std::string("all, convex or concave; or ") + about_edges)
      ->delimiter(',')
      ->type_name("N,N,...");
  command->add_option("--between", options->between, "the edges that two faces have in common")
      ->delimiter(',')
      ->transform(face_word())
      ->type_name("A,B");
  command->add_flag("--partial", options->partial,
                    "do the edges that can be done, and name the others, instead of all or none");
  add_common_options(*command, options->common, "write the new model (.step, .brep, .iges)");
  add_engine_options(*command, options->engine);
  return command;
}

/// Longer files are no laws.
constexpr std::streamsize kMaxOfLaw = 1 << 20;

std::string law_text(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw UsageError("--law: " + file + " cannot be read");
  std::string text(kMaxOfLaw, ' ');
  stream.read(text.data(), kMaxOfLaw);
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

bool is_kind(const std::string& word) {
  return word == "all" || word == "convex" || word == "concave";
}

/// --edges. Where the model is needed, the rest of the word is looked at alone.
void read_edges(FilletCommand& command) {
  for (const std::string& word : command.edge_words) {
    if (is_kind(word)) {
      if (!command.all.empty() && command.all != word)
        throw UsageError("--edges: of " + command.all + " and " + word + " one is wanted");
      command.all = word;
      continue;
    }
    const std::size_t slash = word.rfind('/');
    reports::EdgeChoice tried;
    if (slash != std::string::npos) command.of_parts.push_back(word);
    read_size("--edges", [&] {
      reports::choose_edges(word.substr(slash + 1),
                            slash == std::string::npos ? command.chosen : tried);
    });
    if (tried.own.empty() && slash != std::string::npos) command.has_bare_edge = true;
  }
  command.fillet.own = command.chosen.own;
}

// Whether all edges asked for have radii of their own.
bool has_all_radii(const FilletCommand& command) {
  return command.all.empty() && command.between.empty() && !command.edge_words.empty() &&
         !command.has_bare_edge && std::ranges::all_of(command.chosen.edges, [&](int edge) {
           return command.chosen.own.count(edge) > 0;
         });
}

/// --radius or --law.
void read_radii(FilletCommand& command) {
  read_edges(command);
  if (command.full_round) {
    if (command.size.empty() && command.law.empty() && command.chosen.own.empty()) return;
    throw UsageError("--full-round goes without --radius, --law and radii of edges");
  }
  if (command.size.empty() && command.law.empty() && has_all_radii(command)) return;
  if (command.size.empty() == command.law.empty())
    throw UsageError(
        "blend fillet takes --radius R or --law FILE, and just one of them, unless all edges have "
        "their own, as in --edges 12:5");
  if (command.law.empty()) {
    read_size("--radius", [&] {
      const occt::EdgeRadius of = reports::edge_radius(command.size);
      command.fillet.radius = of.radius;
      command.fillet.law = of.law;
    });
    return;
  }
  command.size = command.law;
  read_size("--law " + command.law,
            [&] { command.fillet.law = reports::radius_law(law_text(command.law)); });
}

}  // namespace

void add_blend_fillet(CLI::App& blend, int& exit_code) {
  const auto options = std::make_shared<FilletCommand>();
  CLI::App* const command = add_edges_command(
      blend, "fillet", "edges of solids rounded by a ball that rolls along them",
      "numbers as info --edges prints them, or edges of parts: 3,5-7 or Bolt/Edge3; 12:5 or "
      "12:2..5 with a radius of its own",
      options);
  command
      ->add_option(
          "--radius", options->size,
          "of the ball, mm; 2..5: from 2 at the start of the edges to 5 at their end; not of "
          "edges with their own")
      ->type_name("R");
  command
      ->add_option(
          "--law", options->law,
          "radii along each run of edges, as JSON: {\"law\": \"smooth\", \"radii\": [2, 5]}, "
          "or \"linear\", or \"table\" with \"at\": [0, 0.3, 1] beside as many radii")
      ->type_name("FILE");
  command
      ->add_option(
          "--section", options->section,
          "circle; conic:RHO with RHO between 0 (flat) and 1 (sharp); g2, which has the curvatures "
          "of both faces; or g3, also with the rates at which these change; circle when not given")
      ->type_name("KIND");
  command
      ->add_option("--setback", options->setback,
                   "how far from a vertex of three and more edges their strips end, mm")
      ->type_name("D");
  command->add_flag("--full-round", options->full_round,
                    "in place of a radius: those with which two straight edges of one plane face "
                    "leave nothing of it, also where they are not parallel");
  command->callback([options, &exit_code] {
    read_radii(*options);
    if (!options->setback.empty())
      read_size("--setback",
                [&] { options->fillet.setback = reports::positive_size(options->setback); });
    if (!options->section.empty())
      read_size("--section",
                [&] { options->fillet.section = reports::fillet_section(options->section); });
    exit_code = run(*options);
  });
}

void add_blend_chamfer(CLI::App& blend, int& exit_code) {
  const auto options = std::make_shared<FilletCommand>();
  CLI::App* const command = add_edges_command(
      blend, "chamfer", "edges of solids cut off",
      "numbers as info --edges prints them, or edges of parts: 3,5-7 or Bolt/Edge3", options);
  command
      ->add_option("--distance", options->size,
                   "of the borders from the edge, mm; 1,2: on the face of the smaller number, on "
                   "the other; 1:30: on the first, and degrees between it and the chamfer")
      ->required()
      ->type_name("D");
  command->callback([options, &exit_code] {
    read_edges(*options);
    if (!options->chosen.own.empty()) throw UsageError("--edges: chamfers have no radii");
    read_size("--distance",
              [&] { options->fillet.chamfer = reports::chamfer_size(options->size); });
    exit_code = run(*options);
  });
}

}  // namespace blossom::cli
