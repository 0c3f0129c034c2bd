// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom info`, `check` and `query distance` of files of triangles.

#pragma once

#include <optional>
#include <string>

#include "plugin/cli/arguments/inputs.h"
#include "plugin/cli/arguments/options.h"
#include "plugin/cli/commands/meshes/meshed_input.h"
#include "plugin/cli/commands/query/query_parts.h"
#include "plugin/cli/output/output.h"

namespace blossom::cli {

/// What the triangles of a file are.
/// groups   whether its groups are listed
int run_mesh_info(const std::string& input, bool groups, const CommonOptions& common);

/// What is wrong with the triangles of a file.
int run_mesh_check(const std::string& input, const CommonOptions& common);

/// What CGAL says of a model's triangles: whether they are closed, cross, and enclose.
struct DeepCheck {
  bool wrong = false;  ///< triangles cross, or are turned against each other
  Json report;
  std::string text;
};

/// Finer triangles are made as long as some cross.
/// throws   UsageError if the program has no CGAL
DeepCheck deep_check(const Input& input);

/// The largest distance of two inputs from each other.
/// within   if given: whether it is at most that
int run_mesh_distance(const std::string& a, const std::string& b, std::optional<double> within,
                      const QueryOptions& options);

}  // namespace blossom::cli
