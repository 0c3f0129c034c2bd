// SPDX-License-Identifier: LGPL-2.1-or-later
// The libraries that jobs load when they meet a file that needs them, by the words of jobs.

#pragma once

#include <functional>
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

/// What loads each, and does nothing if it is loaded.
struct LibraryLoaders {
  std::function<void()> step, documents;  ///< both of `exchange`
  std::function<void()> three_mf;
};

/// Those of the program.
const LibraryLoaders& own_libraries();

/// Loads what is wanted and not loaded, each whatever becomes of the others, and notes what is.
/// What cannot be loaded is left to the jobs, which say so, and tried again for the next one.
void load(const Libraries& wanted, Libraries& loaded, const LibraryLoaders& by = own_libraries());

}  // namespace blossom::cli
