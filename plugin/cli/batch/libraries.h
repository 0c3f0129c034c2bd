// SPDX-License-Identifier: LGPL-2.1-or-later
// The libraries that jobs load when they meet a file that needs them, by the words of jobs.

#pragma once

#include <string>
#include <vector>

namespace blossom::cli {

struct Libraries {
  bool exchange = false;  ///< of STEP, IGES and .glb
  bool three_mf = false;

  bool operator==(const Libraries&) const = default;
};

/// Those that the endings of a job's words name, in any case. What a .zip packs is not known; most
/// are STEP.
Libraries libraries_for(const std::vector<std::string>& arguments);

/// Loads what is wanted and not loaded, which is noted. What cannot be loaded is left to the jobs,
/// which say so.
void load(const Libraries& wanted, Libraries& loaded);

}  // namespace blossom::cli
