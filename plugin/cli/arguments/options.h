// SPDX-License-Identifier: LGPL-2.1-or-later
// Options that commands have in common.

#pragma once

#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "core/surface_intersection.h"
#include "plugin/cli/picture/look.h"
#include "plugin/cli/process/progress.h"

namespace blossom::cli {

struct CommonOptions {
  std::string output;                 ///< -o: a model file; empty for none
  std::string json;                   ///< --json: a file, or "-" for stdout; empty for none
  std::string picture;                ///< --picture: a PNG file; empty for none
  std::string table{};                ///< --table: a CSV file; empty for none
  PictureLook look{};                 ///< of the picture, and what else shows the result
  std::string reproduce{};            ///< --reproduce: a folder, see reproduction.h
  std::string fail_on;                ///< --fail-on: "findings"; empty for nothing
  const CLI::App* command = nullptr;  ///< whose options these are
};

/// What an intersection may be told; for commands that intersect on their way, too.
struct EngineOptions {
  double tolerance = Tolerances{}.point;
  std::string form = "auto";
  long budget = IntersectionOptions{}.budget;
  int threads = 0;
};

/// The group of help texts in which options are that many commands have, behind a command's own.
inline constexpr const char* kShared = "Shared";

/// What every command takes: --json, --strict, --time-limit, --verbose, --quiet. The second is
/// known to reading.h, the third to supervision.h, the last two to verbosity.h.
void add_report_options(CLI::App& command, CommonOptions& options);

/// The same, -o, and what add_picture_options adds.
/// output    what -o gets, for the help text; empty if the command writes no model
void add_common_options(CLI::App& command, CommonOptions& options, const std::string& output);

/// --table.
/// what      has a row
void add_table(CLI::App& command, CommonOptions& options, const std::string& what);

/// --fail-on.
void add_fail_on(CLI::App& command, CommonOptions& options);

/// --tolerance, --form, --budget, --threads.
void add_engine_options(CLI::App& command, EngineOptions& options);

/// The options of the core, with what is left of the time limit; the work ticks `progress` and
/// stops at an interruption.
///
/// progress  has to live as long as the result is used
IntersectionOptions intersection_options(const EngineOptions& options, Progress& progress);

/// What -o takes: models; files of nets (.json), too; those of triangles as well; or drawings
/// (.dxf, .svg) and reports, too.
enum class Outputs { Models, ModelsAndNets, ModelsNetsAndTriangles, ModelsAndDrawings };

/// The ending of a file's name in small letters, ".dxf".
std::string ending_of(const std::string& file);

/// Looks at inputs and outputs before any work is done; looks of inputs are read for an output
/// alone.
///
/// inputs    as the user wrote them
/// throws    UsageError if an output is an input, two outputs are one file, an extension is
///           unknown, a file is no regular one, or as parse_input; occt::Failure if an output is a
///           folder or lies in a folder that cannot be written
void check_files(const CommonOptions& options, const std::vector<std::string>& inputs,
                 Outputs outputs = Outputs::Models);

/// Options that would do nothing are refused.
/// names     those that do nothing here; ones that the command has not are let through
/// why       "b.step is of surfaces"
/// throws    UsageError if one of them is given: "--text does nothing here: b.step is of surfaces"
void refuse_options(const CommonOptions& options, const std::vector<std::string>& names,
                    const std::string& why);

/// Whether a command that looks for something found any of it.
enum class Findings { None, Some };
Findings findings_of(bool any);

/// The exit code of such a command: `code`, or kExitFindings if that is asked for.
int exit_code(int code, Findings findings, const CommonOptions& options);

}  // namespace blossom::cli
