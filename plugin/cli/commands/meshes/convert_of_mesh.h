// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom convert` of files of triangles: to other ones, and to curved patches.

#pragma once

#include <string>

#include "plugin/cli/arguments/options.h"

namespace blossom::cli {

struct MeshInputConversion {
  std::string to;     ///< "bezier" or "triangles", or empty
  double crease = 0;  ///< radians
  bool text = false;
};

int run_conversion_of_mesh(const std::string& input, const CommonOptions& common,
                           const MeshInputConversion& conversion);

}  // namespace blossom::cli
