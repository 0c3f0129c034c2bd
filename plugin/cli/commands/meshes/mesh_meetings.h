// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom intersect` and `blossom query plane` of files of triangles.

#pragma once

#include <string>
#include <vector>

#include "plugin/cli/arguments/options.h"
#include "plugin/reports/queries/section.h"

namespace blossom::cli {

/// The polylines in which two inputs meet, of which at least one is of triangles; the other may be
/// a model, which is meshed. Writes what is wanted, prints, and returns the exit code.
/// throws   UsageError if a picture is wanted, or the program has no CGAL
int run_mesh_intersection(const std::string& a, const std::string& b, const CommonOptions& common);

/// Likewise those in planes.
int run_mesh_sections(const std::string& input, const std::vector<reports::NamedPlane>& planes,
                      const CommonOptions& common);

}  // namespace blossom::cli
