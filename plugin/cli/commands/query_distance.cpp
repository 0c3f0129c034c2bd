// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom query point`, `query distance` and `query does-intersect`.

#include <algorithm>
#include <memory>
#include <sstream>

#include "plugin/cli/commands/query_parts.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/interruption.h"
#include "plugin/cli/options.h"
#include "plugin/cli/reading.h"
#include "plugin/cli/repairs.h"
#include "plugin/cli/supervision.h"
#include "plugin/cli/values.h"

namespace blossom::cli {
namespace {

struct Options {
  std::string a;
  std::string b;     // empty for a point
  std::string at;    // the point
  bool all = false;  // of a point: all feet, too
  long budget = DistanceOptions{}.budget;
  QueryOptions common;
};

// A model made ready to be measured, with the numbers of its parts.
struct Side {
  Input input;
  ShapeNumbers numbers;
  std::unique_ptr<occt::MeasuredShape> shape;

  explicit Side(const std::string& name)
      : input(read_input(name, Faces::Optional)), numbers(input.model.shape()) {}
  void prepare() { shape = std::make_unique<occt::MeasuredShape>(chosen_shape(input)); }
  Json json(const occt::ShapePoint& place) const { return place_json(numbers, input, place); }
  std::string text(const occt::ShapePoint& place) const {
    return place_text(numbers, input, place);
  }
};

DistanceOptions limits(const Options& options) {
  return {.budget = options.budget, .time_limit = seconds_left(), .cancelled = interrupted};
}

Json head(const char* kind, const Options& options, Status status, double seconds) {
  return {{"schema", "blossom.query/1"},
          {"kind", kind},
          {"tolerance", options.common.tolerance},
          {"status", to_string(status)},
          {"seconds", seconds}};
}

std::string bounds_text(double lower, double upper) {
  std::ostringstream text;
  text.precision(12);
  text << "distance " << upper << ", proven to be at least " << lower;
  return text.str();
}

Json feet_json(const Side& side, const std::vector<occt::ShapeFoot>& feet) {
  Json list = Json::array();
  for (const occt::ShapeFoot& found : feet) {
    Json foot = side.json(found.at);
    foot["distance"] = found.foot.distance;
    foot["extremum"] = to_string(found.foot.extremum);
    foot["status"] = to_string(found.foot.status);
    foot["size"] = found.foot.size;
    list.push_back(foot);
  }
  return list;
}

std::string feet_text(const Side& side, const std::vector<occt::ShapeFoot>& feet) {
  std::ostringstream text;
  text.precision(12);
  for (const occt::ShapeFoot& found : feet)
    text << "  foot at " << found.foot.distance << ": " << side.text(found.at) << ", "
         << to_string(found.foot.extremum)
         << (found.foot.status == Status::Complete ? "" : ", not proven") << "\n";
  return text.str();
}

int run_point(const Options& options) {
  check_files(options.common, {options.a});
  const Vec3 point = parse_vector(options.at, "--at");
  Side side(options.a);
  stop_if_interrupted();
  const Stopwatch watch;
  side.prepare();
  const occt::ShapeDistance found = occt::nearest_point(*side.shape, point, limits(options));
  std::vector<occt::ShapeFoot> feet;
  if (options.all) {
    const DistanceOptions left = limits(options);
    const WorkLimit limit(left.time_limit, left.cancelled);
    feet = occt::foot_points(*side.shape, point, options.common.tolerance, &limit);
  }
  Status status = found.status;
  for (const occt::ShapeFoot& foot : feet) status = weaker(status, foot.foot.status);
  Json report = head("point", options, status, watch.seconds());
  stop_if_interrupted();
  report["file"] = side.input.name;
  report["at"] = point.coordinates;
  report["distance"] = {found.lower, found.upper};
  report["nearest"] = side.json(found.b);
  if (options.all) report["feet"] = feet_json(side, feet);
  report["repairs"] = Json::array({repairs_json(side.input)});
  write_answer(report,
               side.input.name + ": " + to_string(stated(status)) + ", " +
                   bounds_text(found.lower, found.upper) + "\n  " + side.text(found.b) + "\n" +
                   feet_text(side, feet),
               options.common);
  return exit_code(status);
}

int run_distance(const Options& options) {
  check_files(options.common, {options.a, options.b});
  Side a(options.a), b(options.b);
  stop_if_interrupted();
  const Stopwatch watch;
  a.prepare();
  b.prepare();
  const occt::ShapeDistance found = occt::least_distance(*a.shape, *b.shape, limits(options));
  Json report = head("distance", options, found.status, watch.seconds());
  stop_if_interrupted();
  report["a"] = a.input.name;
  report["b"] = b.input.name;
  report["distance"] = {found.lower, found.upper};
  report["nearest_a"] = a.json(found.a);
  report["nearest_b"] = b.json(found.b);
  report["repairs"] = Json::array({repairs_json(a.input), repairs_json(b.input)});
  write_answer(report,
               a.input.name + " - " + b.input.name + ": " + to_string(stated(found.status)) + ", " +
                   bounds_text(found.lower, found.upper) + "\n  " + a.text(found.a) + "\n  " +
                   b.text(found.b) + "\n",
               options.common);
  return exit_code(found.status);
}

const char* word(occt::Meeting answer) {
  switch (answer) {
    case occt::Meeting::No: return "no";
    case occt::Meeting::Yes: return "yes";
    case occt::Meeting::Within: return "within tolerance";
    case occt::Meeting::Unknown: break;
  }
  return "unknown";
}

Status status_of(occt::Meeting answer) {
  if (answer == occt::Meeting::Unknown) return Status::Stopped;
  return answer == occt::Meeting::Within ? Status::Tolerance : Status::Complete;
}

int run_does_intersect(const Options& options) {
  check_files(options.common, {options.a, options.b});
  Side a(options.a), b(options.b);
  stop_if_interrupted();
  const Stopwatch watch;
  a.prepare();
  b.prepare();
  const occt::ShapeMeeting found =
      occt::meeting(*a.shape, *b.shape, options.common.tolerance, limits(options));
  Json report = head("does-intersect", options, status_of(found.answer), watch.seconds());
  stop_if_interrupted();
  report["a"] = a.input.name;
  report["b"] = b.input.name;
  report["answer"] = word(found.answer);
  report["distance"] = {found.lower, found.upper};
  report["nearest_a"] = a.json(found.a);
  report["nearest_b"] = b.json(found.b);
  report["repairs"] = Json::array({repairs_json(a.input), repairs_json(b.input)});
  std::string text = a.input.name + " - " + b.input.name + ": " + word(found.answer) + "\n";
  if (found.answer != occt::Meeting::No) text += "  " + a.text(found.a) + "\n";
  write_answer(report, text, options.common);
  return exit_code(status_of(found.answer));
}

void add_budget(CLI::App& command, Options& options) {
  command.add_option("--budget", options.budget, "stop after so many pairs of cells")
      ->check(whole_number(1, 1'000'000'000))
      ->type_name("N")
      ->capture_default_str();
}

void add_pair(CLI::App& query, const char* name, const char* what, int (*run)(const Options&),
              int& exit_code) {
  CLI::App* const command = query.add_subcommand(name, what);
  const auto options = std::make_shared<Options>();
  command->add_option("a", options->a, "model, or some of its faces")->required()->type_name("A");
  command->add_option("b", options->b, "likewise")->required()->type_name("B");
  add_budget(*command, *options);
  add_query_options(*command, options->common);
  command->callback([options, run, &exit_code] { exit_code = run(*options); });
}

}  // namespace

void add_query_point(CLI::App& query, int& exit_code) {
  CLI::App* const command =
      query.add_subcommand("point", "the point of a model nearest to a point");
  const auto options = std::make_shared<Options>();
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
  add_pair(query, "distance", "the least distance of two models", run_distance, exit_code);
}

void add_query_does_intersect(CLI::App& query, int& exit_code) {
  add_pair(query, "does-intersect", "whether two models have a point in common", run_does_intersect,
           exit_code);
}

}  // namespace blossom::cli
