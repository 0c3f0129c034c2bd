// SPDX-License-Identifier: LGPL-2.1-or-later
// Sections of a model with many planes, part by part.

#pragma once

#include <string>
#include <vector>

#include "plugin/cli/arguments/inputs.h"
#include "plugin/cli/arguments/options.h"
#include "plugin/reports/queries/section.h"

namespace blossom::cli {

/// Parallel planes: `FROM:TO:NUMBER`, so many at even steps from the first offset to the last one;
/// or one at an offset.
///
/// throws   UsageError unless it is that; a single one takes equal offsets
std::vector<reports::NamedPlane> planes_at(const std::string& offsets, const occt::Plane& plane);

/// Those of a file: each line has six numbers, a point and a normal, by commas or spaces, and
/// perhaps a name; what follows a # does not count.
/// throws   UsageError, with the line, if it has no planes or a line is none
std::vector<reports::NamedPlane> planes_in(const std::string& file);

/// A model with faces, or with edges that no face has.
/// throws   occt::BadModel if it has neither
Input input_to_cut(const std::string& name);

/// The section with one plane as a drawing or a model, part by part.
void write_parts(const Input& input, const reports::NamedPlane& plane, const EngineOptions& engine,
                 const std::string& file);

/// The model is made ready once. Writes what is asked for, prints, and returns the exit code.
int run_planes(const std::string& input, std::vector<reports::NamedPlane> planes,
               const CommonOptions& common, const EngineOptions& engine);

}  // namespace blossom::cli
