// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom trim PART TOOL... --solid OPERATION`.

#pragma once

#include <string>
#include <vector>

#include "adapters/occt/plane_section.h"
#include "plugin/cli/arguments/options.h"
#include "plugin/cli/output/output.h"

namespace blossom::cli {

struct SolidTrim {
  std::string part;
  std::vector<std::string> tools;
  std::vector<occt::Plane> planes;  ///< above which they cut like a tool, after the tools
  std::string operation;            ///< cut, common, fuse or split
  bool watertight = false;          ///< as untrimmed faces with common sides
  CommonOptions common;
  EngineOptions engine;
};

/// The operations as words of the command line.
bool is_solid_operation(const std::string& word);

/// Does the work, writes the outputs and returns the exit code. Nothing but the report is written
/// when the solids cannot be combined.
/// throws   UsageError as read_input, if an input is no closed solid, or to fuse with planes
int trim_solids(const SolidTrim& options);

}  // namespace blossom::cli
