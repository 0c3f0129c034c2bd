// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/commands/intersect/intersection_parts.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>
#include <vector>

#include <TopExp_Explorer.hxx>

#include "plugin/cli/arguments/hidden.h"
#include "plugin/cli/arguments/values.h"
#include "plugin/cli/commands/intersect/intersection_text.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/output/intersection_model.h"
#include "plugin/cli/output/output.h"
#include "plugin/cli/output/reading.h"
#include "plugin/cli/picture/files.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/cli/process/progress.h"
#include "plugin/cli/process/stages.h"
#include "plugin/pictures/results/intersection.h"

namespace blossom::cli {
namespace {

double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

}  // namespace

void add_intersect_options(CLI::App& command, IntersectOptions& options) {
  add_common_options(command, options.common, "write the edges (.step, .brep, .iges)");
  add_fail_on(command, options.common);
  add_engine_options(command, options.engine);
  command.add_option("--repeat", options.repeat, "do it N times and report the median time")
      ->check(whole_number(1, 1'000'000))
      ->type_name("N")
      ->capture_default_str()
      ->group(kHidden);
  command.add_flag("--joined", options.joined,
                   "write one part of wires, each stretch once, instead of a part for each pair "
                   "of faces");
}

namespace {

// What each pair of faces cost that has something to tell, and all of them together.
void log_pairs(const occt::ShapeIntersection& found) {
  const auto cells = [](const Certificate& certificate) {
    return certificate.cells_bezier + certificate.cells_monomial;
  };
  for (const occt::FaceIntersection& pair : found.pairs)
    log_line({{"pair", {pair.face_a + 1, pair.face_b + 1}},
              {"status", to_string(pair.found.status)},
              {"cells", cells(pair.found.certificate)},
              {"curves", pair.found.curves.size()}});
  log_line({{"pairs", found.face_pairs},
            {"status", to_string(found.status)},
            {"cells", cells(found.certificate)}});
}

}  // namespace

TimedIntersection timed_intersection(
    const IntersectOptions& options,
    const std::function<FoundIntersection(const IntersectionOptions&)>& intersect) {
  Progress progress("intersecting");
  const IntersectionOptions engine = intersection_options(options.engine, progress);
  TimedIntersection result;
  std::vector<double> seconds;
  for (int i = 0; i < options.repeat; ++i) {
    const auto start = std::chrono::steady_clock::now();
    FoundIntersection once = intersect(engine);
    result.found = std::move(once.faces);
    result.edges = std::move(once.edges);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    stop_if_interrupted();
    seconds.push_back(took.count());
  }
  log_pairs(result.found);
  result.times = {median(seconds), seconds.front()};
  return result;
}

int write_outputs(const Input& a, const Input& b, const std::string& title,
                  const TimedIntersection& result, const IntersectOptions& given) {
  const CommonOptions& options = given.common;
  // All that may fail or be interrupted comes before the first file is written.
  const IntersectionCounts counts = counts_of(a, result.found, result.edges);
  occt::JoinedIntersection joined;
  if (given.joined || !options.json.empty() || tells_joined(counts))
    joined =
        occt::joined_intersection(result.found, a.faces, b.faces, [] { return interrupted(); });
  reports::add_edges(result.edges, joined);
  const reports::IntersectionFindings findings{a, b, result.found, joined, result.edges};
  std::optional<occt::Model> model;
  if (!options.output.empty() && given.joined)
    model = joined_model(a, b, joined);
  else if (!options.output.empty() && counts.has_shape())
    model = paired_model(a, b, result.found, result.edges);
  if (model && !TopExp_Explorer(model->shape(), TopAbs_VERTEX).More()) model.reset();
  const bool unwritten = !options.output.empty() && !model;
  const std::vector<PictureFile> pictures = picture_files(options, [&] {
    return pictures::intersection_picture(findings, stated(findings.found.status));
  });
  stop_if_interrupted();

  if (model) write_model(*model, options.output);
  if (unwritten) report_nothing_found(options.output, "no curve and no point was found");
  write_pictures(pictures);
  if (!options.json.empty()) {
    write_json(&a == &b ? reports::self_intersection_report(findings, result.times)
                        : reports::intersection_report(findings, result.times),
               options.json);
  }
  print_summary(intersection_text(findings, title, counts, result.times), options.json);
  return exit_code(exit_code(result.found.status), findings_of(counts.any()), options);
}

}  // namespace blossom::cli
