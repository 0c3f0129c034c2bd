// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom query point`, `query distance` and `query does-intersect`.

#include <functional>
#include <memory>
#include <optional>
#include <sstream>

#include "adapters/occt/bodies.h"
#include "plugin/cli/arguments/options.h"
#include "plugin/cli/arguments/values.h"
#include "plugin/cli/commands/meshes/mesh_commands.h"
#include "plugin/cli/commands/query/query_bodies.h"
#include "plugin/cli/commands/query/query_parts.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/output/reading.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/cli/process/supervision.h"
#include "plugin/reports/queries/distance.h"

namespace blossom::cli {
namespace {

struct DistanceCommand {
  std::string a;
  std::string b;                 // empty for a point
  std::string at;                // the point
  bool all = false;              // of a point: all feet, too
  std::optional<double> within;  // of triangles, or of models as such
  long budget = DistanceOptions{}.budget;
  QueryOptions common;
};

// What is left each time it is asked.
std::function<DistanceOptions()> limits_of(const DistanceCommand& options) {
  return [&options] {
    return DistanceOptions{
        .budget = options.budget, .time_limit = seconds_left(), .cancelled = interrupted};
  };
}

std::string bounds_text(double lower, double upper) {
  std::ostringstream text;
  text.precision(12);
  text << "distance " << upper;
  if (lower < upper) text << ", proven to be at least " << lower;
  return text.str();
}

std::string feet_text(const QuerySide& side, const std::vector<occt::ShapeFoot>& feet) {
  std::ostringstream text;
  text.precision(12);
  for (const occt::ShapeFoot& found : feet)
    text << "  foot at " << found.foot.distance << ": " << side.text(found.at) << ", "
         << to_string(found.foot.extremum)
         << (found.foot.status == Status::Complete ? "" : ", not proven") << "\n";
  return text.str();
}

std::string places_text(const QuerySide& side, const std::vector<occt::PointPlace>& places) {
  std::string text;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (places[i] != occt::PointPlace::Outside)
      text += std::string("  ") + to_string(places[i]) + ": " + side.body_text(i) + "\n";
  if (text.empty() && !places.empty()) text = "  outside of all closed solids\n";
  return text;
}

int run_point(const DistanceCommand& options) {
  check_files(options.common, {options.a});
  const Vec3 point = parse_vector(options.at, "--at");
  QuerySide side(options.a);
  stop_if_interrupted();
  const Stopwatch watch;
  side.prepare();
  reports::PointAnswer found =
      reports::nearest_to(side, point, options.all, options.common.tolerance, limits_of(options));
  found.seconds = watch.seconds();
  stop_if_interrupted();
  write_answer(reports::point_report(side, found),
               side.input.name + ": " + to_string(stated(found.status)) + ", " +
                   bounds_text(found.nearest.lower, found.nearest.upper) + "\n  " +
                   side.text(found.nearest.b) + "\n" + places_text(side, found.places) +
                   feet_text(side, found.feet),
               options.common);
  return exit_code(found.status);
}

// The answer to a question about two inputs, with the time it took.
reports::DistanceAnswer asked(const DistanceCommand& options, QuerySide& a, QuerySide& b,
                              decltype(reports::distance_between)* question) {
  stop_if_interrupted();
  const Stopwatch watch;
  a.prepare();
  b.prepare();
  reports::DistanceAnswer found = question(a, b, options.common.tolerance, limits_of(options));
  found.seconds = watch.seconds();
  stop_if_interrupted();
  return found;
}

int run_distance(const DistanceCommand& options) {
  if (options.within || is_mesh_input(options.a) || is_mesh_input(options.b))
    return run_mesh_distance(options.a, options.b, options.within, options.common);
  check_files(options.common, {options.a, options.b});
  QuerySide a(options.a), b(options.b);
  const reports::DistanceAnswer found = asked(options, a, b, reports::distance_between);
  std::string text = a.input.name + " - " + b.input.name + ": " + to_string(stated(found.status)) +
                     ", " + bounds_text(found.bounds.lower, found.bounds.upper) + ", " +
                     relation_text(found.relation.relation, a, b) + "\n";
  if (found.bounds.upper < found.boundaries.upper)
    text += "  boundaries: " + bounds_text(found.boundaries.lower, found.boundaries.upper) + "\n";
  write_answer(reports::distance_report(a, b, found),
               text + "  " + a.text(found.a) + "\n  " + b.text(found.b) + "\n" +
                   relation_lines(found.relation, a, b),
               options.common);
  return exit_code(found.status);
}

int run_does_intersect(const DistanceCommand& options) {
  check_files(options.common, {options.a, options.b});
  QuerySide a(options.a), b(options.b);
  const reports::DistanceAnswer found = asked(options, a, b, reports::meeting_of);
  const occt::Relation relation = found.relation.relation;
  std::string text = a.input.name + " - " + b.input.name + ": " + reports::meeting_word(relation) +
                     (stated(found.status) == Status::Complete
                          ? ""
                          : std::string(", ") + to_string(stated(found.status))) +
                     (has_common_points(relation) ? ", " + relation_text(relation, a, b) : "") +
                     "\n";
  if (found.meeting != occt::Meeting::No) text += "  " + a.text(found.a) + "\n";
  write_answer(reports::meeting_report(a, b, found), text + relation_lines(found.relation, a, b),
               options.common);
  return exit_code(exit_code(found.status), findings_of(has_common_points(relation)),
                   options.common);
}

void add_budget(CLI::App& command, DistanceCommand& options) {
  command.add_option("--budget", options.budget, "stop after so many pairs of cells")
      ->check(whole_number(1, 1'000'000'000))
      ->type_name("N")
      ->capture_default_str();
}

std::shared_ptr<DistanceCommand> add_pair(CLI::App& query, const char* name, const char* what,
                                          int (*run)(const DistanceCommand&), int& exit_code) {
  CLI::App* const command = query.add_subcommand(name, what);
  const auto options = std::make_shared<DistanceCommand>();
  command->add_option("a", options->a, "model, or some of its faces")->required()->type_name("A");
  command->add_option("b", options->b, "likewise")->required()->type_name("B");
  add_budget(*command, *options);
  add_fail_on(*command, options->common);
  add_query_options(*command, options->common);
  command->callback([options, run, &exit_code] { exit_code = run(*options); });
  return options;
}

}  // namespace

void add_query_point(CLI::App& query, int& exit_code) {
  CLI::App* const command =
      query.add_subcommand("point", "the point of a model nearest to a point");
  const auto options = std::make_shared<DistanceCommand>();
  command->add_option("input", options->a, "model, or some of its faces")
      ->required()
      ->type_name("FILE");
  command->add_option("--at", options->at, "the point")->required()->type_name("X,Y,Z");
  command->add_flag("--all", options->all, "all points where the distance is stationary, too");
  add_budget(*command, *options);
  add_query_options(*command, options->common);
  command->callback([options, &exit_code] { exit_code = run_point(*options); });
}

void add_query_distance(CLI::App& query, int& exit_code) {
  const std::shared_ptr<DistanceCommand> options = add_pair(
      query, "distance",
      "the least distance of two models; of triangles (.stl, .ply, .obj, .off) the largest, "
      "both ways",
      run_distance, exit_code);
  CLI::App* const command = query.get_subcommand("distance");
  CLI::Option* const within =
      command
          ->add_option("--within", options->within,
                       "whether all of one is that near to the other, both ways; of models, too")
          ->check(positive_number())
          ->type_name("D");
  command->get_option("--fail-on")->needs(within);
}

void add_query_does_intersect(CLI::App& query, int& exit_code) {
  add_pair(query, "does-intersect",
           "whether two models have a point in common, and whether one is inside of the other",
           run_does_intersect, exit_code);
}

}  // namespace blossom::cli
