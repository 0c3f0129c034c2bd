// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom query point`, `query distance` and `query does-intersect`.

#include <algorithm>
#include <memory>
#include <sstream>

#include "adapters/occt/bodies.h"
#include "plugin/cli/commands/query_bodies.h"
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
  text << "distance " << upper;
  if (lower < upper) text << ", proven to be at least " << lower;
  return text.str();
}

Json feet_json(const QuerySide& side, const std::vector<occt::ShapeFoot>& feet) {
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

std::string feet_text(const QuerySide& side, const std::vector<occt::ShapeFoot>& feet) {
  std::ostringstream text;
  text.precision(12);
  for (const occt::ShapeFoot& found : feet)
    text << "  foot at " << found.foot.distance << ": " << side.text(found.at) << ", "
         << to_string(found.foot.extremum)
         << (found.foot.status == Status::Complete ? "" : ", not proven") << "\n";
  return text.str();
}

Json places_json(const QuerySide& side, const std::vector<occt::PointPlace>& places) {
  Json list = Json::array();
  for (std::size_t i = 0; i < places.size(); ++i) {
    Json solid = side.body_json(i);
    solid["place"] = to_string(places[i]);
    list.push_back(std::move(solid));
  }
  return list;
}

std::string places_text(const QuerySide& side, const std::vector<occt::PointPlace>& places) {
  std::string text;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (places[i] != occt::PointPlace::Outside)
      text += std::string("  ") + to_string(places[i]) + ": " + side.body_text(i) + "\n";
  if (text.empty() && !places.empty()) text = "  outside of all closed solids\n";
  return text;
}

int run_point(const Options& options) {
  check_files(options.common, {options.a});
  const Vec3 point = parse_vector(options.at, "--at");
  QuerySide side(options.a);
  stop_if_interrupted();
  const Stopwatch watch;
  side.prepare();
  const occt::ShapeDistance found =
      occt::nearest_point(side.bodies->boundary(), point, limits(options));
  std::vector<occt::ShapeFoot> feet;
  if (options.all) {
    const DistanceOptions left = limits(options);
    const WorkLimit limit(left.time_limit, left.cancelled);
    feet = occt::foot_points(side.bodies->boundary(), point, options.common.tolerance, &limit);
  }
  const std::vector<occt::PointPlace> places =
      occt::places_of(*side.bodies, point, found, options.common.tolerance, limits(options));
  Status status = found.status;
  for (const occt::ShapeFoot& foot : feet) status = weaker(status, foot.foot.status);
  Json report = head("point", options, status, watch.seconds());
  stop_if_interrupted();
  report["file"] = side.input.name;
  report["at"] = point.coordinates;
  report["distance"] = {found.lower, found.upper};
  report["nearest"] = side.json(found.b);
  report["solids"] = places_json(side, places);
  if (options.all) report["feet"] = feet_json(side, feet);
  report["repairs"] = Json::array({repairs_json(side.input)});
  write_answer(report,
               side.input.name + ": " + to_string(stated(status)) + ", " +
                   bounds_text(found.lower, found.upper) + "\n  " + side.text(found.b) + "\n" +
                   places_text(side, places) + feet_text(side, feet),
               options.common);
  return exit_code(status);
}

// The distance of the models: none where they have points in common, else that of their boundaries.
// While it is not known whether they do, it may be none.
struct Bounds {
  double lower = 0, upper = 0;
};
Bounds distance_of(occt::Relation relation, const Bounds& boundaries) {
  if (has_common_points(relation)) return {};
  const bool known = relation != occt::Relation::Unknown;
  return {known ? boundaries.lower : 0, boundaries.upper};
}

int run_distance(const Options& options) {
  check_files(options.common, {options.a, options.b});
  QuerySide a(options.a), b(options.b);
  stop_if_interrupted();
  const Stopwatch watch;
  a.prepare();
  b.prepare();
  const double tolerance = options.common.tolerance;
  const occt::ShapeDistance found =
      occt::least_distance(a.bodies->boundary(), b.bodies->boundary(), limits(options));
  const occt::ShapeMeeting meeting = occt::meeting_at(
      found, a.bodies->boundary(), b.bodies->boundary(), tolerance, limits(options));
  const occt::ModelRelation relation =
      occt::relation_of(*a.bodies, *b.bodies, meeting, tolerance, limits(options));
  const Bounds bounds = distance_of(relation.relation, {found.lower, found.upper});
  const bool open = bounds.lower < found.lower && !has_common_points(relation.relation);
  const Status status = open ? weaker(found.status, relation.status) : found.status;
  Json report = head("distance", options, status, watch.seconds());
  stop_if_interrupted();
  report["a"] = a.input.name;
  report["b"] = b.input.name;
  report["distance"] = {bounds.lower, bounds.upper};
  report["boundary_distance"] = {found.lower, found.upper};
  report["nearest_a"] = a.json(found.a);
  report["nearest_b"] = b.json(found.b);
  report["repairs"] = Json::array({repairs_json(a.input), repairs_json(b.input)});
  add_relation(relation, a, b, report);
  std::string text = a.input.name + " - " + b.input.name + ": " + to_string(stated(status)) + ", " +
                     bounds_text(bounds.lower, bounds.upper) + ", " +
                     relation_text(relation.relation, a, b) + "\n";
  if (bounds.upper < found.upper)
    text += "  boundaries: " + bounds_text(found.lower, found.upper) + "\n";
  write_answer(report,
               text + "  " + a.text(found.a) + "\n  " + b.text(found.b) + "\n" +
                   relation_lines(relation, a, b),
               options.common);
  return exit_code(status);
}

const char* answer_of(occt::Relation relation) {
  switch (relation) {
    case occt::Relation::Unknown: return "unknown";
    case occt::Relation::Disjoint: return "no";
    case occt::Relation::Touching: return "touching";
    default: return "yes";
  }
}

// A pair that has common points for sure proves the answer, whatever the others are.
Status status_of_answer(const occt::ModelRelation& found) {
  const bool proven = std::ranges::any_of(found.pairs, [](const occt::BodyPair& pair) {
    return has_common_points(pair.relation) && pair.status == Status::Complete;
  });
  return proven ? Status::Complete : found.status;
}

int run_does_intersect(const Options& options) {
  check_files(options.common, {options.a, options.b});
  QuerySide a(options.a), b(options.b);
  stop_if_interrupted();
  const Stopwatch watch;
  a.prepare();
  b.prepare();
  const double tolerance = options.common.tolerance;
  const occt::ShapeMeeting found =
      occt::meeting(a.bodies->boundary(), b.bodies->boundary(), tolerance, limits(options));
  const occt::ModelRelation relation =
      occt::relation_of(*a.bodies, *b.bodies, found, tolerance, limits(options));
  const Status status = status_of_answer(relation);
  Json report = head("does-intersect", options, status, watch.seconds());
  stop_if_interrupted();
  report["a"] = a.input.name;
  report["b"] = b.input.name;
  report["answer"] = answer_of(relation.relation);
  const Bounds bounds = distance_of(relation.relation, {found.lower, found.upper});
  report["distance"] = {bounds.lower, bounds.upper};
  report["boundary_distance"] = {found.lower, found.upper};
  report["nearest_a"] = a.json(found.a);
  report["nearest_b"] = b.json(found.b);
  report["repairs"] = Json::array({repairs_json(a.input), repairs_json(b.input)});
  add_relation(relation, a, b, report);
  std::string text =
      a.input.name + " - " + b.input.name + ": " + answer_of(relation.relation) +
      (stated(status) == Status::Complete ? "" : std::string(", ") + to_string(stated(status))) +
      (has_common_points(relation.relation) ? ", " + relation_text(relation.relation, a, b) : "") +
      "\n";
  if (found.answer != occt::Meeting::No) text += "  " + a.text(found.a) + "\n";
  write_answer(report, text + relation_lines(relation, a, b), options.common);
  return exit_code(status);
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
  add_pair(query, "distance", "the least distance of two models; 0 if one is inside of the other",
           run_distance, exit_code);
}

void add_query_does_intersect(CLI::App& query, int& exit_code) {
  add_pair(query, "does-intersect",
           "whether two models have a point in common, and whether one is inside of the other",
           run_does_intersect, exit_code);
}

}  // namespace blossom::cli
