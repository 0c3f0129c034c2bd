// SPDX-License-Identifier: LGPL-2.1-or-later
// The assembly of a model, for people and for programs.

#pragma once

#include <string>

#include "adapters/occt/shapes.h"
#include "plugin/cli/output/output.h"

namespace blossom::cli {

struct TreeList {
  Json json;
  std::string text;
};

/// All parts and assemblies with their names, and the numbers of their solids and faces.
TreeList tree_list(const occt::Model& model);

}  // namespace blossom::cli
