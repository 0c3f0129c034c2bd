// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom convert F -o OUT` where OUT is of triangles.

#pragma once

#include <string>

#include <CLI/App.hpp>

#include "core/tessellation/facet_options.h"
#include "plugin/cli/arguments/options.h"

namespace blossom::cli {

struct MeshConversion {
  double deviation = 0;  ///< 0: a part of the model's size
  FacetOptions facets;   ///< all but the deviation
  bool text = false;
};

/// --deviation, --angle, --edge-length, --text.
void add_mesh_options(CLI::App& command, MeshConversion& options);

/// Whether an output is of triangles: .stl, .ply, .obj, .off, .3mf, .glb.
bool is_of_triangles(const std::string& file);

/// Reads, meshes, writes, reports.
int run_mesh_conversion(const std::string& input, const CommonOptions& common,
                        const MeshConversion& options);

}  // namespace blossom::cli
