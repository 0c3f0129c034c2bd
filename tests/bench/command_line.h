// SPDX-License-Identifier: LGPL-2.1-or-later
// What the programs that measure models by a list of files have in common.

#pragma once

#include <cstdio>
#include <optional>

#include "adapters/occt/shapes.h"

namespace blossom::bench {

/// Runs with the settings of the command line; prints the usage and returns 2 if there are none.
template <class Settings>
int run_command(const std::optional<Settings>& settings, const char* usage,
                int (*run_all)(const Settings&)) {
  if (!settings) {
    std::fprintf(stderr, "%s\n", usage);
    return 2;
  }
  occt::quiet_messages();
  return run_all(*settings);
}

}  // namespace blossom::bench
