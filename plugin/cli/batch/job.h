// SPDX-License-Identifier: LGPL-2.1-or-later
// One job of a batch: a command line of the program, by a name.

#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace blossom::cli {

struct Job {
  std::string id;
  std::vector<std::string> arguments;  ///< without the program; no shell ever sees them
};

inline constexpr std::size_t kMaxJobLine = std::size_t{1} << 20;  ///< bytes of a line of a job list
inline constexpr std::size_t kMaxJobArguments = 10'000;
inline constexpr std::size_t kMaxJobId = 1'000;  ///< bytes

/// A line of a job list, see plugin/cli/schemas/job-1.md.
/// place    the list and the number of the line, for messages
/// throws   UsageError if it is no job, or beyond a limit
Job parse_job(const std::string& line, const std::string& place);

/// throws   UsageError if a job may not have these arguments
void check_command(const std::vector<std::string>& arguments, const std::string& place);

/// Puts a file's name in the place of {}, without its ending in that of {.}, without the folder in
/// that of {/}, and without both in that of {/.}.
std::string filled_in(const std::string& argument, const std::string& file);

/// For telling whether a job is the one that a result is of.
std::size_t hash_of(const std::vector<std::string>& arguments);

}  // namespace blossom::cli
