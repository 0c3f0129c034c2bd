// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom check F`: what is wrong with a model, with gaps measured beside stated tolerances.

#include <algorithm>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "adapters/occt/soundness.h"
#include "plugin/cli/arguments/inputs.h"
#include "plugin/cli/arguments/options.h"
#include "plugin/cli/commands/check/check_continuity.h"
#include "plugin/cli/commands/commands.h"
#include "plugin/cli/commands/meshes/mesh_commands.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/output/output.h"
#include "plugin/cli/output/reading.h"
#include "plugin/cli/picture/files.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/cli/process/many_files.h"
#include "plugin/pictures/results/models.h"
#include "plugin/reports/models/soundness.h"

namespace blossom::cli {
namespace {

constexpr const char* kNotSound = "not sound";

struct CheckCommand {
  std::vector<std::string> inputs;
  bool deep = false;
  CommonOptions common;
  ContinuityCommand continuity;
};

// What is wrong in one way with faces or edges.
struct Kind {
  const char* noun = "";  // face or edge
  std::size_t problems = 0;
  std::set<int> members{}, faces{};
  occt::Problem worst{};
  std::string at{};  // that the worst one is
};

void add(const char* noun, int number, const std::vector<int>& faces, const FaceLabels& labels,
         const std::vector<occt::Problem>& problems, std::vector<Kind>& kinds) {
  std::string name =
      std::string_view(noun) == "face" ? labels.of(number) : noun + (' ' + std::to_string(number));
  if (std::string_view(noun) == "edge") {
    name += " (face";
    for (const int face : faces) name += ' ' + std::to_string(face);
    name += ')';
  }
  for (const occt::Problem& problem : problems) {
    auto kind = std::ranges::find_if(kinds, [&](const Kind& known) {
      return known.noun == std::string_view(noun) && known.worst.what == problem.what;
    });
    if (kind == kinds.end()) kind = kinds.insert(kind, {noun});
    if (kind->problems++ == 0 || problem.gap > kind->worst.gap) {
      kind->worst = problem;
      kind->at = name;
    }
    kind->members.insert(number);
    kind->faces.insert(faces.begin(), faces.end());
  }
}

// "2-4 7 9-12"
std::string ranges_text(const std::set<int>& numbers) {
  std::string text;
  for (auto it = numbers.begin(); it != numbers.end();) {
    const int first = *it;
    int last = first;
    while (++it != numbers.end() && *it == last + 1) ++last;
    text += (text.empty() ? "" : " ") + std::to_string(first);
    if (last > first) text += '-' + std::to_string(last);
  }
  return text;
}

// One line: the problem, or how many there are and the worst of them.
std::string kind_text(const Kind& kind) {
  const occt::Problem& worst = kind.worst;
  if (kind.problems == 1) return kind.at + ": " + worst.text();
  std::string text = counted(kind.members.size(), kind.noun) +
                     (kind.faces.size() == 1 ? " (face " : " (faces ") + ranges_text(kind.faces) +
                     "): " + worst.what;
  if (kind.problems > kind.members.size()) text += ", " + std::to_string(kind.problems) + " times";
  if (worst.figure().empty()) return text;
  return text + (worst.gap > 0 ? ", at worst " : ", one of them ") + kind.at + worst.figure();
}

// wrong   what triangles of it told
std::string check_text(const Input& input, const occt::Soundness& found, bool wrong) {
  const reports::LargestGaps all = reports::largest_of(found);
  const std::size_t count = reports::problem_count(found);
  std::ostringstream text;
  text << input.name << ": " << (wrong ? kNotSound : reports::verdict_of(found))
       << (count == 0 ? "" : ": " + counted(count, "problem")) << ", "
       << counted(found.faces.size(), "face") << ", " << counted(found.edges.size(), "edge")
       << "\n  gap of curves and surfaces " << all.gap << ", at the same parameter "
       << all.same_parameter << ", to vertices " << all.vertex_gap << "; largest tolerance stated "
       << all.tolerance << "\n  " << counted(static_cast<std::size_t>(all.free), "open edge")
       << ", " << counted(static_cast<std::size_t>(all.crowded), "non-manifold edge") << "\n";
  for (const std::string& problem : found.problems) text << "  " << problem << "\n";
  const FaceLabels labels(input);
  std::vector<Kind> kinds;
  for (const occt::FaceSoundness& face : found.faces)
    add("face", face.number, {face.number}, labels, face.problems, kinds);
  for (const occt::EdgeSoundness& edge : found.edges)
    add("edge", edge.number, edge.faces, labels, edge.problems, kinds);
  for (const Kind& kind : kinds) text << "  " << kind_text(kind) << "\n";
  if (found.problems.size() + kinds.size() < count)
    text << "  --json lists each of them, with its figures\n";
  return text.str();
}

std::string number_in(const Json& report, const char* member) {
  return report.at(member).is_null() ? "" : report.at(member).dump();
}

bool is_of_mesh(const Json& report) { return report.at("schema") == "blossom.mesh-check/1"; }

std::size_t problems_of_mesh(const Json& report) {
  std::size_t count = 0;
  for (const char* const member :
       {"open_sides", "non_manifold_sides", "turned_sides", "degenerate", "crossings"})
    count += report.at(member).get<std::size_t>();
  // Turned inside out is one, too.
  return count == 0 && report.at("verdict") != "sound" ? 1 : count;
}

std::vector<std::string> check_fields(const Json& report) {
  if (is_of_mesh(report))
    return {report.at("verdict").get<std::string>(),
            std::to_string(problems_of_mesh(report)),
            number_in(report, "triangles"),
            "",
            number_in(report, "open_sides"),
            number_in(report, "non_manifold_sides"),
            "",
            "",
            "",
            ""};
  const Json& all = report.at("summary");
  return {report.at("verdict").get<std::string>(),
          number_in(report, "problem_count"),
          std::to_string(report.at("faces").size()),
          std::to_string(report.at("edges").size()),
          number_in(all, "free_edges"),
          number_in(all, "crowded_edges"),
          number_in(all, "gap"),
          number_in(all, "same_parameter"),
          number_in(all, "vertex_gap"),
          number_in(all, "tolerance")};
}

std::string check_words(const Json& report) {
  if (is_of_mesh(report)) {
    const std::size_t count = problems_of_mesh(report);
    return report.at("verdict").get<std::string>() +
           (count == 0 ? "" : ": " + counted(count, "problem")) + ", " +
           counted(report.at("triangles").get<std::size_t>(), "triangle");
  }
  const auto problems = report.at("problem_count").get<std::size_t>();
  return report.at("verdict").get<std::string>() +
         (problems == 0 ? "" : ": " + counted(problems, "problem")) + ", " +
         counted(report.at("faces").size(), "face") + ", " +
         counted(report.at("edges").size(), "edge");
}

int run_on_many(const CLI::App& command, const CheckCommand& options) {
  if (options.continuity.wanted)
    throw UsageError("--continuity takes one model, and goes without --table");
  return run_many({&command,
                   options.inputs,
                   options.common,
                   {"verdict", "problems", "faces", "edges", "open_edges", "non_manifold_edges",
                    "gap", "same_parameter", "vertex_gap", "tolerance"},
                   check_fields,
                   check_words});
}

int run(const CheckCommand& options) {
  if (options.continuity.wanted)
    return run_continuity(options.inputs.front(), options.common, options.continuity);
  if (is_mesh_input(options.inputs.front()))
    return run_mesh_check(options.inputs.front(), options.common);
  check_files(options.common, options.inputs);
  const Input input = read_input(options.inputs.front());
  stop_if_interrupted();
  const bool whole = static_cast<int>(input.numbers.size()) == input.model.face_count();
  const occt::CheckRunner checks = watched_checks(input.model.file());
  const occt::Soundness found = whole ? occt::soundness(input.model.shape(), checks)
                                      : occt::soundness(input.model.shape(), input.numbers, checks);
  const DeepCheck deep = options.deep ? deep_check(input) : DeepCheck{};
  stop_if_interrupted();
  const std::vector<PictureFile> pictures =
      picture_files(options.common, [&] { return pictures::soundness_picture(input, found); });
  stop_if_interrupted();
  write_pictures(pictures);
  const std::string& json = options.common.json;
  Json report = reports::soundness_report(input, found);
  if (options.deep) report["triangles"] = deep.report;
  if (deep.wrong) report["verdict"] = kNotSound;
  if (!json.empty()) write_json(report, json);
  print_summary(check_text(input, found, deep.wrong) + deep.text, json);
  const bool wrong = reports::problem_count(found) > 0 || deep.wrong;
  return exit_code(kExitComplete, findings_of(wrong), options.common);
}

}  // namespace

void add_check(CLI::App& app, int& exit_code) {
  CLI::App* const command = app.add_subcommand(
      "check",
      "what is wrong with a model: validity, gaps beside stated tolerances, wires, open edges");
  const auto options = std::make_shared<CheckCommand>();
  command
      ->add_option(
          "input", options->inputs,
          "model, or some of its faces; or triangles, as .stl, .ply, .obj or .off; or many "
          "of them")
      ->required()
      ->type_name("FILE");
  add_common_options(*command, options->common, "");
  add_table(*command, options->common, "each model");
  add_fail_on(*command, options->common);
  command->add_flag("--deep", options->deep,
                    "also mesh the whole model and look for triangles that cross");
  add_continuity_options(*command, options->continuity);
  command->callback([options, command, &exit_code] {
    exit_code = are_many(options->inputs, options->common) ? run_on_many(*command, *options)
                                                           : run(*options);
  });
}

}  // namespace blossom::cli
