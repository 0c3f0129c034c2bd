// SPDX-License-Identifier: LGPL-2.1-or-later
// Commands on many files: each file in a process of its own, so that none is the end of the others.

#pragma once

#include <functional>
#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "plugin/cli/arguments/options.h"
#include "plugin/cli/output/output.h"

namespace blossom::cli {

/// What the command said of one file.
struct FileRun {
  std::string file;
  int code = 0;       ///< the exit code for this file alone
  std::string error;  ///< why there is no report; empty if there is one
  Json report;
};

struct ManyFiles {
  const CLI::App* command = nullptr;  ///< with the options that each file gets, too
  std::vector<std::string> inputs;
  CommonOptions common;
  std::vector<std::string> titles;  ///< of the table's columns between the file and the exit code
  /// The fields of these columns.
  std::function<std::vector<std::string>(const Json& report)> fields;
  /// What is printed of a file after its name.
  std::function<std::string(const Json& report)> words;
};

/// Whether a command is about many files, or about one as about many: for a table.
bool are_many(const std::vector<std::string>& inputs, const CommonOptions& common);

/// Runs the command on each file, prints a line for each, and writes the table and the report
/// ("blossom.files/1", see plugin/cli/schemas/files-1.md) as far as they are wanted. A file that
/// cannot be used has a row with the reason. When the time limit is reached, so have those that are
/// left.
/// returns   the exit code: of the worst file, in the order 1, 2, 4, 5, 3, 0
/// throws    UsageError if outputs of single files are asked for; Interrupted
int run_many(const ManyFiles& files);

}  // namespace blossom::cli
