// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom self-intersect F`: where faces meet themselves or each other, with a certificate.

#include <memory>
#include <string>

#include "core/base/parallel.h"
#include "plugin/cli/commands/commands.h"
#include "plugin/cli/commands/intersection_parts.h"
#include "plugin/cli/interruption.h"

namespace blossom::cli {
namespace {

struct Options {
  std::string input;
  bool all_faces = false;
  IntersectOptions intersect;
};

int run(const Options& options) {
  check_files(options.intersect.common, {options.input});
  start_threads(options.intersect.engine.threads);
  const Input input = read_input(options.input);
  stop_if_interrupted();
  const auto scope = options.all_faces ? occt::SelfScope::AllFaces : occt::SelfScope::EachFace;
  const TimedIntersection result =
      timed_intersection(options.intersect, [&](const IntersectionOptions& engine) {
        return occt::self_intersect(input.faces, scope, engine);
      });
  return write_outputs(input, input, input.name + " with itself", result, options.intersect.common);
}

}  // namespace

void add_self_intersect(CLI::App& app, int& exit_code) {
  CLI::App* const command =
      app.add_subcommand("self-intersect", "where each face of a model meets itself");
  const auto options = std::make_shared<Options>();
  command->add_option("input", options->input, "model, or some of its faces")
      ->required()
      ->type_name("FILE");
  command->add_flag("--faces", options->all_faces,
                    "also different faces with each other; what they share is left out");
  add_intersect_options(*command, options->intersect);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace blossom::cli
