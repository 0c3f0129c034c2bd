// SPDX-License-Identifier: LGPL-2.1-or-later
// What reading the inputs lost, for all commands: one line on stderr, a member of every report, and
// no status better than `tolerance` when shapes are missing.

#pragma once

#include <filesystem>
#include <optional>

#include "adapters/occt/shapes.h"
#include "adapters/occt/soundness.h"
#include "core/base/status.h"
#include "plugin/reports/text/json.h"

namespace blossom::cli {

/// How inputs are read; the options of the command set it.
struct ReadingPolicy {
  bool strict = false;  ///< --strict: a file of which shapes are missing is refused
  std::optional<double> sew =
      {};             ///< --sew-gap: how wide a gap between loose faces may be; 0 for none
  bool looks = true;  ///< colours, layers and dimensions are wanted: a model is written
};
ReadingPolicy& reading_policy();

/// Reads a model, telling the supervision each step, says on stderr what is lost, and keeps it for
/// the reports.
/// throws   occt::BadModel as read_model, or if shapes are missing and the policy is strict
occt::Model read_and_report(const std::filesystem::path& file);

/// Does checks of a file's shapes as optional steps (see supervision.h), each with as much
/// processor time as reading has.
/// throws   Interrupted between two of them
occt::CheckRunner watched_checks(const std::filesystem::path& file);

/// Adds the member "reading" to a report, a list of the files that were read, and takes the status
/// "complete" back if shapes are missing.
void add_reading(reports::Json& report);

/// Says that faces of a file are left out of the answer, as if reading had lost them.
void leave_faces_out();

/// A status as it may be said of an answer: at most Tolerance if shapes are missing.
Status stated(Status status);

/// Likewise the exit code of a command that is done.
int stated_exit_code(int code);

}  // namespace blossom::cli
