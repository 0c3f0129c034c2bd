// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom query ray F --from P --direction D`: what a ray or line hits.

#include <functional>
#include <memory>
#include <sstream>

#include "adapters/occt/ray_casting.h"
#include "core/base/unbounded.h"
#include "plugin/cli/arguments/options.h"
#include "plugin/cli/commands/query/query_parts.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/output/reading.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/cli/process/supervision.h"
#include "plugin/reports/queries/rays.h"

namespace blossom::cli {
namespace {

struct RayCommand {
  std::string input;
  std::string from;
  std::string direction;
  bool first = false;
  bool line = false;
  QueryOptions common;
};

Ray ray_of(const RayCommand& options) {
  Ray ray;
  ray.origin = parse_vector(options.from, "--from");
  const Vec3 direction = parse_vector(options.direction, "--direction");
  const double largest = max_norm(direction);
  if (largest == 0) throw UsageError("--direction: the zero vector has no direction");
  ray.direction = unit(direction * (1 / largest));  // lengths are then model units
  if (options.line) ray.from = -kInfinity;
  return ray;
}

int face_number(const Input& input, const occt::ShapeHit& hit) {
  return input.numbers[static_cast<std::size_t>(hit.hit.surface)];
}

std::string text_of(const Input& input, const reports::RayAnswer& answer) {
  const ShapeNumbers numbers(input.model.shape());
  std::ostringstream text;
  text.precision(12);
  text << input.name << ": " << to_string(stated(answer.status)) << ", "
       << counted(answer.hits.size(), "hit") << "\n";
  for (const occt::ShapeHit& found : answer.hits) {
    const RayHit& hit = found.hit;
    text << "  " << hit.parameter << " at " << vector_text(hit.point) << ", "
         << numbers.text(found.on, face_number(input, found));
    const TopoDS_Face& face = input.faces[static_cast<std::size_t>(hit.surface)];
    if (const std::string part = reports::part_with(input, face); !part.empty())
      text << " of " << part;
    if (hit.last > hit.first) text << ", from " << hit.first << " to " << hit.last;
    if (hit.grazing) text << ", grazing";
    if (hit.status != Status::Complete) text << ", " << to_string(hit.status);
    text << "\n";
  }
  return text.str();
}

int run(const RayCommand& options) {
  reports::RayAnswer answer{.ray = ray_of(options),
                            .line = options.line,
                            .first_only = options.first,
                            .tolerance = options.common.tolerance};
  check_files(options.common, {options.input});
  const Input input = read_usable_input(options.input);
  stop_if_interrupted();
  const Stopwatch watch;
  const std::function<bool()> cancelled = interrupted;
  const WorkLimit limit(seconds_left(), cancelled);
  try {
    const occt::ShapeRays rays(input.faces, options.common.tolerance, &limit);
    answer.hits = options.first ? rays.first_hits(answer.ray) : rays.all_hits(answer.ray);
  } catch (const occt::LimitFailure&) {  // nothing is known, then
    answer.status = Status::Stopped;
  }
  answer.seconds = watch.seconds();
  for (const occt::ShapeHit& hit : answer.hits)
    answer.status = weaker(answer.status, hit.hit.status);
  stop_if_interrupted();
  write_answer(reports::ray_report(input, answer), text_of(input, answer), options.common);
  return exit_code(answer.status);
}

}  // namespace

void add_query_ray(CLI::App& query, int& exit_code) {
  CLI::App* const command = query.add_subcommand("ray", "what a ray or line hits, in order");
  const auto options = std::make_shared<RayCommand>();
  command->add_option("input", options->input, "model, or some of its faces")
      ->required()
      ->type_name("FILE");
  command->add_option("--from", options->from, "where the ray starts")
      ->required()
      ->type_name("X,Y,Z");
  command->add_option("--direction", options->direction, "where it goes; of any length")
      ->required()
      ->type_name("X,Y,Z");
  command->add_flag("--first", options->first, "no further than the first proven hit");
  command->add_flag("--line", options->line, "both ways, not only forwards");
  add_query_options(*command, options->common);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace blossom::cli
