// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom blend fill` of files of triangles.

#pragma once

#include <string>

#include "plugin/cli/arguments/options.h"

namespace blossom::cli {

/// Fills all holes and writes the whole mesh.
int run_fill_of_mesh(const std::string& input, const CommonOptions& common);

}  // namespace blossom::cli
