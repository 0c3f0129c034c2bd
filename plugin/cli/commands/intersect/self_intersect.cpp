// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom self-intersect F`: where faces meet themselves or each other, with a certificate.

#include <memory>
#include <string>

#include "core/base/parallel.h"
#include "plugin/cli/commands/commands.h"
#include "plugin/cli/commands/intersect/intersection_parts.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/cli/process/many_files.h"

namespace blossom::cli {
namespace {

struct SelfIntersectCommand {
  std::vector<std::string> inputs;
  bool all_faces = false;
  IntersectOptions intersect;
};

std::vector<std::string> self_fields(const Json& report) {
  std::vector<std::string> fields{report.at("verdict").get<std::string>(),
                                  report.at("status").get<std::string>()};
  for (const char* list : {"curves", "points", "overlaps", "places"})
    fields.push_back(std::to_string(report.contains(list) ? report.at(list).size() : 0));
  fields.push_back(report.contains("seconds") ? report.at("seconds").dump() : "");
  return fields;
}

std::string self_words(const Json& report) {
  return report.at("verdict").get<std::string>() + ", " + report.at("status").get<std::string>() +
         ", " + counted(report.at("curves").size(), "curve") + ", " +
         counted(report.at("points").size(), "point");
}

int run_on_many(const CLI::App& command, const SelfIntersectCommand& options) {
  return run_many({&command,
                   options.inputs,
                   options.intersect.common,
                   {"verdict", "status", "curves", "points", "overlaps", "places", "seconds"},
                   self_fields,
                   self_words});
}

int run(const SelfIntersectCommand& options) {
  check_files(options.intersect.common, options.inputs);
  start_threads(options.intersect.engine.threads);
  const Input input = read_usable_input(options.inputs.front());
  stop_if_interrupted();
  const auto scope = options.all_faces ? occt::SelfScope::AllFaces : occt::SelfScope::EachFace;
  const TimedIntersection result =
      timed_intersection(options.intersect, [&](const IntersectionOptions& engine) {
        return FoundIntersection{occt::self_intersect(input.faces, scope, engine)};
      });
  return write_outputs(input, input, input.name + " with itself", result, options.intersect);
}

}  // namespace

void add_self_intersect(CLI::App& app, int& exit_code) {
  CLI::App* const command =
      app.add_subcommand("self-intersect", "where each face of a model meets itself");
  const auto options = std::make_shared<SelfIntersectCommand>();
  command->add_option("input", options->inputs, "model, or some of its faces; or many models")
      ->required()
      ->type_name("FILE");
  command->add_flag("--faces", options->all_faces,
                    "also different faces with each other; what they share is left out");
  add_intersect_options(*command, options->intersect);
  add_table(*command, options->intersect.common, "each model");
  command->callback([options, command, &exit_code] {
    exit_code = are_many(options->inputs, options->intersect.common)
                    ? run_on_many(*command, *options)
                    : run(*options);
  });
}

}  // namespace blossom::cli
