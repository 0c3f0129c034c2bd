// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom subdivide --whole`: one B-spline for each face or edge.

#pragma once

#include <string>
#include <vector>

#include "plugin/cli/arguments/options.h"
#include "plugin/cli/output/output.h"

namespace blossom::cli {

struct WholeQuestion {
  std::string input;
  std::vector<double> interval;   ///< of edges; empty with `rectangle`, and for whole faces
  std::vector<double> rectangle;  ///< of faces
  CommonOptions common;
};

/// Writes what is asked for, prints, and returns the exit code.
int run_whole(const WholeQuestion& question);

}  // namespace blossom::cli
