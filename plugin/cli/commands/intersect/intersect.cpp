// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom intersect A B`: all intersections of two models, with a certificate.

#include <memory>
#include <string>
#include <vector>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/intersection.h"
#include "core/base/parallel.h"
#include "plugin/cli/arguments/inputs.h"
#include "plugin/cli/commands/commands.h"
#include "plugin/cli/commands/intersect/intersection_parts.h"
#include "plugin/cli/commands/meshes/mesh_meetings.h"
#include "plugin/cli/commands/meshes/meshed_input.h"
#include "plugin/cli/output/output.h"
#include "plugin/cli/output/verbosity.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/reports/cuts/edge_findings.h"

namespace blossom::cli {
namespace {

struct IntersectCommand {
  std::string a;
  std::string b;
  IntersectOptions intersect;
};

// What cannot be used is told by file and face where an open wire is the cause.
FoundIntersection intersect_named(const Input& a, const Input& b,
                                  const IntersectionOptions& engine) try {
  const occt::SharedLimit limit(engine);
  FoundIntersection found{occt::intersect(a.faces, b.faces, engine)};
  found.edges = reports::edge_findings(a, b, limit.remaining_alone());
  reports::add_status(found.edges, found.faces);
  return found;
} catch (const occt::BadModel&) {
  for (const Input* input : {&a, &b}) refuse_open_wires(*input);
  throw;
}

// Edges that are not named are what a drawing of the faces has beside them.
Input input_to_intersect(const std::string& name) {
  Input input =
      read_usable_input(name, Faces::Optional, reports::Repairing::Used, reports::LooseFaces::Kept);
  if (input.faces.empty() && reports::edges_to_intersect(input).empty())
    throw occt::BadModel(input.name + ": there is no face and no edge in it");
  if (const std::vector<int> others = reports::edges_left_out(input); !others.empty()) {
    const std::string them = others.size() == 1 ? "it" : "them";
    note(input.name + ": " + counted(others.size(), "edge") + " without faces left out; name " +
         them + " to intersect " + them + ", as #edge:" + std::to_string(others.front()));
  }
  return input;
}

int run(const IntersectCommand& options) {
  if (is_mesh_input(options.a) || is_mesh_input(options.b))
    return run_mesh_intersection(options.a, options.b, options.intersect.common);
  check_files(options.intersect.common, {options.a, options.b});
  start_threads(options.intersect.engine.threads);
  const Input a = input_to_intersect(options.a);
  const Input b = input_to_intersect(options.b);
  stop_if_interrupted();
  const TimedIntersection result = timed_intersection(
      options.intersect,
      [&](const IntersectionOptions& engine) { return intersect_named(a, b, engine); });
  return write_outputs(a, b, a.name + " x " + b.name, result, options.intersect);
}

}  // namespace

void add_intersect(CLI::App& app, int& exit_code) {
  CLI::App* const command =
      app.add_subcommand("intersect", "all intersections of two models or meshes");
  const auto options = std::make_shared<IntersectCommand>();
  command->add_option("a", options->a, "model, some of its faces or edges, or triangles")
      ->required()
      ->type_name("A");
  command->add_option("b", options->b, "likewise")->required()->type_name("B");
  add_intersect_options(*command, options->intersect);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace blossom::cli
