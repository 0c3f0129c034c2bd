// SPDX-License-Identifier: LGPL-2.1-or-later
// What `blossom intersect` and `blossom self-intersect` have in common.

#pragma once

#include <functional>
#include <string>

#include "adapters/occt/intersection.h"
#include "plugin/cli/arguments/inputs.h"
#include "plugin/cli/arguments/options.h"
#include "plugin/reports/cuts/intersection.h"

namespace blossom::cli {

struct IntersectOptions {
  int repeat = 1;
  bool joined = false;  ///< --joined
  CommonOptions common;
  EngineOptions engine;
};

/// The options of output and engine, and --repeat.
void add_intersect_options(CLI::App& command, IntersectOptions& options);

struct TimedIntersection {
  occt::ShapeIntersection found;
  reports::EdgeFindings edges;
  reports::RunTimes times;
};

/// What one run finds.
struct FoundIntersection {
  occt::ShapeIntersection faces;
  reports::EdgeFindings edges{};
};

/// Does it as often as the options say.
/// throws   Interrupted
TimedIntersection timed_intersection(
    const IntersectOptions& options,
    const std::function<FoundIntersection(const IntersectionOptions&)>& intersect);

/// Writes edges, picture, report and summary, as far as they are wanted; returns the exit code.
/// a, b      one object for an input with itself
/// title     of the summary
int write_outputs(const Input& a, const Input& b, const std::string& title,
                  const TimedIntersection& result, const IntersectOptions& options);

}  // namespace blossom::cli
