// SPDX-License-Identifier: LGPL-2.1-or-later
// What the kinds of `blossom query` have in common.

#pragma once

#include <chrono>
#include <string>

#include <CLI/App.hpp>
#include <TopoDS_Shape.hxx>

#include "adapters/occt/distance.h"
#include "core/base/tolerances.h"
#include "core/math/vec.h"
#include "plugin/cli/arguments/inputs.h"
#include "plugin/cli/arguments/options.h"
#include "plugin/cli/arguments/vectors.h"
#include "plugin/cli/output/output.h"
#include "plugin/reports/models/measured_input.h"

namespace blossom::cli {

using reports::ShapeNumbers;

struct QueryOptions : CommonOptions {
  double tolerance = Tolerances{}.point;
};

/// Those of reports, and --tolerance.
void add_query_options(CLI::App& command, QueryOptions& options);

/// Seconds since its making.
class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// "(1, 2, 3) on face 2".
std::string place_text(const ShapeNumbers& numbers, const Input& input,
                       const occt::ShapePoint& place);

/// Writes the report where it is wanted, and the text unless the report is on stdout.
void write_answer(const Json& report, const std::string& text, const QueryOptions& options);

void add_query_plane(CLI::App& query, int& exit_code);
void add_query_ray(CLI::App& query, int& exit_code);
void add_query_point(CLI::App& query, int& exit_code);
void add_query_distance(CLI::App& query, int& exit_code);
void add_query_does_intersect(CLI::App& query, int& exit_code);
void add_query_mass(CLI::App& query, int& exit_code);

}  // namespace blossom::cli
