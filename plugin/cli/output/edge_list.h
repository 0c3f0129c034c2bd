// SPDX-License-Identifier: LGPL-2.1-or-later
// The edges of a model, as `blossom info --edges` lists them.

#pragma once

#include <string>

#include "plugin/cli/output/output.h"
#include "plugin/reports/models/input.h"

namespace blossom::cli {

/// Number, faces, kind, angle, length and middle point of each edge.
struct EdgeList {
  Json json;         ///< a list, see plugin/cli/schemas/info-1.md
  std::string text;  ///< a table with a line for each
};

/// Of what the input names; the numbers are those of the whole model.
EdgeList edge_list(const reports::Input& input);

}  // namespace blossom::cli
