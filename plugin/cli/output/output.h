// SPDX-License-Identifier: LGPL-2.1-or-later
// Where results go: stdout or a file, never half of one.

#pragma once

#include <string>

#include "adapters/occt/shapes.h"
#include "plugin/reports/text/json.h"

namespace blossom::cli {

using reports::counted;
using reports::Json;

/// Writes a result to stdout.
/// throws   occt::Failure if stdout does not take it (a full disk, a closed pipe)
void print(const std::string& text);

/// Writes JSON on one line. Numbers are the shortest that read back as the same double; what is not
/// finite is null.
/// target   a file, or "-" for stdout
/// throws   occt::Failure if it cannot be written; what was there before is then still there
void write_plain_json(const Json& json, const std::string& target);

/// Likewise a report, with what reading the inputs lost.
void write_json(Json report, const std::string& target);

/// Writes a model, see occt::write_model; an interruption leaves what was there before.
void write_model(const occt::Model& model, const std::string& file);

/// Whether a name that --json got is one of the program's open streams, or /dev/null: no file.
bool is_stream(const std::string& target);

/// Writes a summary to stdout, unless -q was given or the report is there.
/// json     what --json got; empty without it
void print_summary(const std::string& text, const std::string& json);

/// Says on stderr that a file is not written as there is nothing to write in it, which is the
/// answer; if there is a file of that name, that it is an older one.
void report_nothing_found(const std::string& file, const std::string& reason);

/// The same of a file that should be there. The program's exit code is that of exit_code_unwritten.
void report_unwritten(const std::string& file, const std::string& reason);

/// Whether any was told.
bool is_file_unwritten();

}  // namespace blossom::cli
