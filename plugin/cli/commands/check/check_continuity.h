// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom check --continuity F`: how smoothly faces meet along every edge.

#pragma once

#include <string>

#include <CLI/App.hpp>

#include "adapters/occt/blending/continuity.h"
#include "plugin/cli/arguments/options.h"

namespace blossom::cli {

struct ContinuityCommand {
  bool wanted = false;  ///< --continuity
  ContinuityTolerances tolerances;
  std::string require;  ///< --require: "G0", "G1", "G2", or empty
  bool table = false;
  bool zebra = false;  ///< --zebra
};

/// --continuity, --gap, --angle, --curvature, --require, --zebra, --edges.
void add_continuity_options(CLI::App& command, ContinuityCommand& options);

/// Reads, measures, reports; returns the exit code.
int run_continuity(const std::string& input, const CommonOptions& common,
                   const ContinuityCommand& options);

}  // namespace blossom::cli
