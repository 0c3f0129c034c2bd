// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom intersect A B`: all intersections of two models, with a certificate.

#include <algorithm>
#include <chrono>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <vector>

#include "adapters/occt/intersection.h"
#include "core/base/parallel.h"
#include "plugin/cli/commands/commands.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/inputs.h"
#include "plugin/cli/interruption.h"
#include "plugin/cli/intersection_model.h"
#include "plugin/cli/intersection_report.h"
#include "plugin/cli/options.h"
#include "plugin/cli/output.h"
#include "plugin/cli/picture/picture.h"
#include "plugin/cli/progress.h"

namespace blossom::cli {
namespace {

struct Options {
  std::string a;
  std::string b;
  int repeat = 1;
  CommonOptions common;
  EngineOptions engine;
};

double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

struct Timed {
  occt::ShapeIntersection found;
  RunTimes times;
};

Timed timed_intersection(const Input& a, const Input& b, const Options& options) {
  Progress progress("intersecting", options.common.quiet);
  const IntersectionOptions engine = intersection_options(options.engine, progress);
  Timed result;
  std::vector<double> seconds;
  for (int i = 0; i < options.repeat; ++i) {
    const auto start = std::chrono::steady_clock::now();
    result.found = occt::intersect(a.faces, b.faces, engine);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    stop_if_interrupted();
    seconds.push_back(took.count());
  }
  result.times = {median(seconds), seconds.front()};
  return result;
}

struct Counts {
  std::size_t curves = 0;
  std::size_t closed = 0;
  std::size_t points = 0;
  std::size_t nodes = 0;
  std::size_t places = 0;
};

Counts counts_of(const occt::ShapeIntersection& found) {
  Counts counts;
  for (const occt::FaceIntersection& pair : found.pairs) {
    counts.curves += pair.found.curves.size();
    counts.closed += static_cast<std::size_t>(
        std::ranges::count_if(pair.found.curves, &IntersectionCurve::closed));
    counts.points += pair.found.points.size();
    counts.nodes += pair.found.nodes.size();
    counts.places += pair.found.places.size();
  }
  return counts;
}

std::string summary(const Input& a, const Input& b, const Timed& result) {
  const Counts counts = counts_of(result.found);
  std::ostringstream text;
  text << a.name << " x " << b.name << ": " << to_string(result.found.status) << ", "
       << counted(counts.curves, "curve") << " (" << counts.closed << " closed), "
       << counted(counts.points, "point") << ", " << counted(counts.nodes, "node") << ", "
       << counted(counts.places, "place") << ", " << result.times.seconds << " s\n";
  for (const occt::FaceIntersection& pair : result.found.pairs) {
    const int face_a = a.numbers[static_cast<std::size_t>(pair.face_a)];
    const int face_b = b.numbers[static_cast<std::size_t>(pair.face_b)];
    for (const IntersectionCurve& curve : pair.found.curves)
      text << "  faces " << face_a << " x " << face_b << ": " << (curve.closed ? "closed" : "open")
           << (curve.tangential ? ", tangential" : "") << ", length " << curve.length << ", degree "
           << curve.curve.degree << ", " << counted(curve.curve.points.size(), "pole")
           << ", deviation "
           << std::max({curve.deviation.a, curve.deviation.b, curve.deviation.between}) << "\n";
  }
  for (const std::string& reason : result.found.certificate.reasons) text << "  " << reason << "\n";
  return text.str();
}

Picture picture_of(const Input& a, const Input& b, const occt::ShapeIntersection& found) {
  Picture picture;
  picture.groups = {{a.faces, kFirstColour, kFirstOpacity},
                    {b.faces, kSecondColour, kSecondOpacity}};
  for (const occt::FaceIntersection& pair : found.pairs) {
    for (const IntersectionCurve& curve : pair.found.curves) {
      picture.curves.emplace_back();
      for (const SurfacePoint& sample : curve.samples)
        picture.curves.back().push_back(sample.point);
    }
    for (const auto* points : {&pair.found.points, &pair.found.nodes})
      for (const SurfacePoint& point : *points) picture.points.push_back(point.point);
  }
  return picture;
}

void write_outputs(const Input& a, const Input& b, const Timed& result,
                   const CommonOptions& options) {
  // All that may fail or be interrupted comes before the first file is written.
  const Counts counts = counts_of(result.found);
  std::optional<occt::Model> model;
  if (!options.output.empty() && counts.curves + counts.points > 0)
    model = intersection_model(a, b, result.found);
  std::string png;
  if (!options.picture.empty()) png = picture_png(picture_of(a, b, result.found));
  stop_if_interrupted();

  if (model)
    occt::write_model(*model, options.output);
  else if (!options.output.empty())
    std::cerr << "blossom: nothing was found, " << options.output << " is not written\n";
  if (!options.picture.empty()) occt::write_text(png, options.picture);
  if (!options.json.empty())
    write_json(intersection_report(a, b, result.found, result.times), options.json);
  if (options.json != "-" && !options.quiet) print(summary(a, b, result));
}

int run(const Options& options) {
  check_outputs(options.common);
  start_threads(options.engine.threads);
  const Input a = read_input(options.a);
  Input b = read_input(options.b);
  share_model(a, b);
  stop_if_interrupted();
  const Timed result = timed_intersection(a, b, options);
  write_outputs(a, b, result, options.common);
  return exit_code(result.found.status);
}

}  // namespace

void add_intersect(CLI::App& app, int& exit_code) {
  CLI::App* const command = app.add_subcommand("intersect", "all intersections of two models");
  const auto options = std::make_shared<Options>();
  command->add_option("a", options->a, "model, or some of its faces")->required()->type_name("A");
  command->add_option("b", options->b, "likewise")->required()->type_name("B");
  add_common_options(*command, options->common, "write the edges (.step, .brep, .iges)");
  add_engine_options(*command, options->engine);
  command->add_option("--repeat", options->repeat, "do it N times and report the median time")
      ->check(CLI::Range(1, 1'000'000))
      ->type_name("N")
      ->capture_default_str();
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace blossom::cli
