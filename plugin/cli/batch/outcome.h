// SPDX-License-Identifier: LGPL-2.1-or-later
// How a job came out, and the line of JSON that says so.

#pragma once

#include <string>
#include <vector>

#include "plugin/cli/batch/job.h"
#include "plugin/cli/output/output.h"

namespace blossom::cli {

/// See the table in plugin/cli/batch/README.md.
enum class JobStatus { Done, Stopped, Failed };

const char* to_string(JobStatus status);

struct Outcome {
  JobStatus status = JobStatus::Failed;
  int code = 1;          ///< the exit code that the command line has by itself
  bool crashed = false;  ///< a signal ended it
  std::string out;       ///< what it wrote to stdout
  std::string err;       ///< what it wrote to stderr
  int attempts = 1;      ///< how often it was begun
  double seconds = 0;    ///< of the last attempt
  double memory = 0;     ///< most that it had, MB
};

/// The line without its end, see plugin/cli/schemas/result-1.md. Reports are a member of it.
std::string result_line(const Job& job, const Outcome& outcome);

/// What of a line the rest of the batch needs.
struct Result {
  std::string id;
  JobStatus status = JobStatus::Failed;
  int code = 1;
  double seconds = 0;
  std::string message;        ///< what it said last on stderr, without the program's name
  std::size_t arguments = 0;  ///< see hash_of
};

/// throws   UsageError if it is no line of a result
Result parse_result(const std::string& line, const std::string& place);

}  // namespace blossom::cli
