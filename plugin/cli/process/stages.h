// SPDX-License-Identifier: LGPL-2.1-or-later
// What a command was at, and for how long: --log and --profile.
//
// A stage is what the supervision is told (see `enter`): it lasts until the next one. The child
// writes each stage when it has ended; the parent writes the last one, which may have been ended by
// a crash or a limit.

#pragma once

#include <string>

#include "plugin/reports/text/json.h"

namespace blossom::cli {

/// Makes room for stages that this process and its children to come share, and begins the first.
void share_stages();

/// The work goes on with something else. Allocates nothing unless there is a log or a profile.
void begin_stage(const std::string& what);

/// By the parent: the work has ended, in this way: "exit code 0". Writes what is still to be
/// written.
void end_stages(const std::string& how);

/// Writes each stage as a line of JSON at the end of a file, see plugin/cli/schemas/log-1.md.
/// throws   UsageError if its ending is not .jsonl or .log; occt::Failure if it cannot be opened
void log_stages(const std::string& file);

/// Prints on stderr, at the end, which stages took longest.
void profile_stages();

/// Adds a line to the log, if there is one.
void log_line(const reports::Json& line);

}  // namespace blossom::cli
