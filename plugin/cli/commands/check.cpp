// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom check F`: what is wrong with a model, with gaps measured beside stated tolerances.

#include <algorithm>
#include <memory>
#include <sstream>

#include "adapters/occt/soundness.h"
#include "plugin/cli/commands/commands.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/inputs.h"
#include "plugin/cli/interruption.h"
#include "plugin/cli/options.h"
#include "plugin/cli/output.h"

namespace blossom::cli {
namespace {

struct Options {
  std::string input;
  std::string json;
};

/// Figures of a face, or of all that was looked at.
struct Largest {
  double tolerance = 0;
  double gap = 0;
  double same_parameter = 0;
  double vertex_gap = 0;
  int free = 0;
  int crowded = 0;

  void add(const occt::EdgeSoundness& edge) {
    tolerance = std::max(tolerance, edge.tolerance);
    gap = std::max(gap, edge.gap);
    same_parameter = std::max(same_parameter, edge.same_parameter);
    vertex_gap = std::max(vertex_gap, edge.vertex_gap);
    free += edge.free ? 1 : 0;
    crowded += edge.crowded ? 1 : 0;
  }
};

Largest largest_of(const occt::Soundness& found) {
  Largest all;
  for (const occt::EdgeSoundness& edge : found.edges) all.add(edge);
  return all;
}

Largest largest_of(const occt::Soundness& found, const occt::FaceSoundness& face) {
  Largest all;
  for (const occt::EdgeSoundness& edge : found.edges)
    if (std::ranges::find(edge.faces, face.number) != edge.faces.end()) all.add(edge);
  return all;
}

std::size_t problem_count(const occt::Soundness& found) {
  std::size_t count = found.problems.size();
  for (const occt::FaceSoundness& face : found.faces) count += face.problems.size();
  for (const occt::EdgeSoundness& edge : found.edges) count += edge.problems.size();
  return count;
}

Json to_json(const Largest& all) {
  return {{"tolerance", all.tolerance},
          {"gap", all.gap},
          {"same_parameter", all.same_parameter},
          {"vertex_gap", all.vertex_gap},
          {"free_edges", all.free},
          {"crowded_edges", all.crowded}};
}

Json edge_json(const occt::EdgeSoundness& edge) {
  return {{"number", edge.number},
          {"faces", edge.faces},
          {"tolerance", edge.tolerance},
          {"gap", edge.gap},
          {"same_parameter", edge.same_parameter},
          {"vertex_gap", edge.vertex_gap},
          {"vertex_tolerance", edge.vertex_tolerance},
          {"free", edge.free},
          {"crowded", edge.crowded},
          {"problems", edge.problems}};
}

Json check_json(const Input& input, const occt::Soundness& found) {
  Json faces = Json::array(), edges = Json::array();
  for (const occt::FaceSoundness& face : found.faces) {
    Json json = {{"number", face.number}, {"edges", face.edges}};
    json.update(to_json(largest_of(found, face)));
    json["problems"] = face.problems;
    faces.push_back(std::move(json));
  }
  for (const occt::EdgeSoundness& edge : found.edges) edges.push_back(edge_json(edge));
  const std::size_t count = problem_count(found);
  return {{"schema", "blossom.check/1"},
          {"file", input.name},
          {"sound", count == 0},
          {"problem_count", count},
          {"summary", to_json(largest_of(found))},
          {"problems", found.problems},
          {"faces", std::move(faces)},
          {"edges", std::move(edges)}};
}

std::string check_text(const Input& input, const occt::Soundness& found) {
  const Largest all = largest_of(found);
  const std::size_t count = problem_count(found);
  std::ostringstream text;
  text << input.name << ": " << (count == 0 ? "sound" : counted(count, "problem")) << ", "
       << counted(found.faces.size(), "face") << ", " << counted(found.edges.size(), "edge")
       << "\n  gap of curves and surfaces " << all.gap << ", at the same parameter "
       << all.same_parameter << ", to vertices " << all.vertex_gap << "; largest tolerance stated "
       << all.tolerance << "\n  " << counted(static_cast<std::size_t>(all.free), "free edge")
       << ", " << counted(static_cast<std::size_t>(all.crowded), "edge")
       << " used more than twice\n";
  for (const std::string& problem : found.problems) text << "  " << problem << "\n";
  for (const occt::FaceSoundness& face : found.faces)
    for (const std::string& problem : face.problems)
      text << "  face " << face.number << ": " << problem << "\n";
  for (const occt::EdgeSoundness& edge : found.edges)
    for (const std::string& problem : edge.problems) {
      text << "  edge " << edge.number << " (face";
      for (const int face : edge.faces) text << ' ' << face;
      text << "): " << problem << "\n";
    }
  return text.str();
}

int run(const Options& options) {
  CommonOptions outputs;
  outputs.json = options.json;
  check_outputs(outputs);
  const Input input = read_input(options.input);
  stop_if_interrupted();
  const bool whole = static_cast<int>(input.numbers.size()) == input.model.face_count();
  const occt::Soundness found = whole ? occt::soundness(input.model.shape())
                                      : occt::soundness(input.model.shape(), input.numbers);
  stop_if_interrupted();
  if (options.json != "-") print(check_text(input, found));
  if (!options.json.empty()) write_json(check_json(input, found), options.json);
  return problem_count(found) == 0 ? kExitComplete : kExitTolerance;
}

}  // namespace

void add_check(CLI::App& app, int& exit_code) {
  CLI::App* const command = app.add_subcommand(
      "check",
      "validity, gaps beside stated tolerances, wires, free edges; 3 if anything is wrong");
  const auto options = std::make_shared<Options>();
  command->add_option("input", options->input, "model, or some of its faces")
      ->required()
      ->type_name("FILE");
  command->add_option("--json", options->json, "write a report; - is stdout")->type_name("FILE");
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace blossom::cli
