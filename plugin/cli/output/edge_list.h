// SPDX-License-Identifier: LGPL-2.1-or-later
// The edges of a model, as `blossom info --edges` lists them.

#pragma once

#include <string>

#include <TopoDS_Shape.hxx>

#include "plugin/cli/output/output.h"

namespace blossom::cli {

/// Number, faces, kind, angle, length and middle point of each edge.
struct EdgeList {
  Json json;         ///< a list, see plugin/cli/schemas/info-1.md
  std::string text;  ///< a table with a line for each
};

EdgeList edge_list(const TopoDS_Shape& shape);

}  // namespace blossom::cli
