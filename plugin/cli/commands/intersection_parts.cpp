// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/commands/intersection_parts.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <sstream>
#include <vector>

#include "plugin/cli/interruption.h"
#include "plugin/cli/intersection_model.h"
#include "plugin/cli/output.h"
#include "plugin/cli/picture/picture.h"
#include "plugin/cli/progress.h"
#include "plugin/cli/reading.h"

namespace blossom::cli {
namespace {

double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
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
    counts.curves += pair.chains.size();
    counts.closed +=
        static_cast<std::size_t>(std::ranges::count_if(pair.chains, &CurveChain::closed));
    counts.points += pair.found.points.size();
    counts.nodes += pair.found.nodes.size();
    counts.places += pair.found.places.size();
  }
  return counts;
}

std::string faces_text(int a, int b, bool itself) {
  if (itself && a == b) return "face " + std::to_string(a);
  return "faces " + std::to_string(a) + " x " + std::to_string(b);
}

std::string summary(const Input& a, const Input& b, const std::string& title,
                    const TimedIntersection& result) {
  const Counts counts = counts_of(result.found);
  std::ostringstream text;
  text << title << ": " << to_string(stated(result.found.status)) << ", "
       << counted(counts.curves, "curve") << " (" << counts.closed << " closed), "
       << counted(counts.points, "point") << ", " << counted(counts.nodes, "node") << ", "
       << counted(counts.places, "place") << ", " << result.times.seconds << " s\n";
  for (const occt::FaceIntersection& pair : result.found.pairs) {
    const int face_a = a.numbers[static_cast<std::size_t>(pair.face_a)];
    const int face_b = b.numbers[static_cast<std::size_t>(pair.face_b)];
    for (const CurveChain& chain : pair.chains) {
      const ChainFacts facts = facts_of(pair.found.curves, chain);
      const Deviation& d = facts.deviation;
      text << "  " << faces_text(face_a, face_b, &a == &b) << ": "
           << (chain.closed ? "closed" : "open") << (facts.tangential ? ", tangential" : "")
           << ", length " << facts.length << ", degree " << facts.degree << ", "
           << counted(facts.poles, "pole") << ", deviation " << std::max({d.a, d.b, d.between})
           << "\n";
    }
  }
  for (const std::string& reason : result.found.certificate.reasons) text << "  " << reason << "\n";
  return text.str();
}

Picture picture_of(const Input& a, const Input& b, const occt::ShapeIntersection& found) {
  Picture picture;
  picture.groups = {{a.faces, kFirstColour, &a == &b ? kSecondOpacity : kFirstOpacity}};
  if (&a != &b) picture.groups.push_back({b.faces, kSecondColour, kSecondOpacity});
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

}  // namespace

void add_intersect_options(CLI::App& command, IntersectOptions& options) {
  add_common_options(command, options.common, "write the edges (.step, .brep, .iges)");
  add_engine_options(command, options.engine);
  command.add_option("--repeat", options.repeat, "do it N times and report the median time")
      ->check(CLI::Range(1, 1'000'000))
      ->type_name("N")
      ->capture_default_str();
}

TimedIntersection timed_intersection(
    const IntersectOptions& options,
    const std::function<occt::ShapeIntersection(const IntersectionOptions&)>& intersect) {
  Progress progress("intersecting");
  const IntersectionOptions engine = intersection_options(options.engine, progress);
  TimedIntersection result;
  std::vector<double> seconds;
  for (int i = 0; i < options.repeat; ++i) {
    const auto start = std::chrono::steady_clock::now();
    result.found = intersect(engine);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    stop_if_interrupted();
    seconds.push_back(took.count());
  }
  result.times = {median(seconds), seconds.front()};
  return result;
}

void write_outputs(const Input& a, const Input& b, const std::string& title,
                   const TimedIntersection& result, const CommonOptions& options) {
  // All that may fail or be interrupted comes before the first file is written.
  const Counts counts = counts_of(result.found);
  std::optional<occt::Model> model;
  const bool unwritten = !options.output.empty() && counts.curves + counts.points == 0;
  if (!options.output.empty() && !unwritten) model = intersection_model(a, b, result.found);
  std::string png;
  if (!options.picture.empty()) png = picture_png(picture_of(a, b, result.found));
  stop_if_interrupted();

  if (model) write_model(*model, options.output);
  if (unwritten) tell_unwritten(options.output, "no curve and no point was found");
  if (!options.picture.empty()) occt::write_text(png, options.picture);
  if (!options.json.empty())
    write_json(&a == &b ? self_intersection_report(a, result.found, result.times)
                        : intersection_report(a, b, result.found, result.times),
               options.json);
  print_summary(summary(a, b, title, result), options.json);
}

}  // namespace blossom::cli
