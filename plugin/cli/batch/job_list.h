// SPDX-License-Identifier: LGPL-2.1-or-later
// The jobs of a batch, from a file of JSON lines or from a pattern of file names.
//
// Of a file only the places of its lines are in memory, 8 bytes a job; of stdin and of a pattern
// the jobs themselves.

#pragma once

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "plugin/cli/batch/job.h"

namespace blossom::cli {

/// The part of a list that one of several runs does: jobs number, number + count, ...
struct Shard {
  std::size_t number = 1;  ///< from 1
  std::size_t count = 1;
};

/// throws   UsageError if it is not as "3/16"
Shard parse_shard(const std::string& text);

inline constexpr std::size_t kMaxShards = 1'000'000;
inline constexpr std::size_t kMaxMatches = 10'000'000;  ///< files of a pattern

class JobList {
 public:
  /// A file, or "-" for stdin. Every line is looked at, those of other shards, too; empty lines
  /// are left out.
  /// throws   UsageError for a line that is no job; occt::BadModel if there is no file
  static JobList of_file(const std::string& file, Shard shard);

  /// A job for each file that the pattern is true of, named after it; see filled_in.
  /// throws   UsageError if there is none
  static JobList of_pattern(const std::string& pattern, const std::vector<std::string>& command,
                            Shard shard);

  /// How many are of the shard.
  std::size_t size() const { return stays_in_memory_ ? jobs_.size() : places_.size(); }

  /// A job of the shard, from 0.
  /// throws   UsageError if the file was changed meanwhile
  Job at(std::size_t number);

 private:
  void keep(Job job);

  bool stays_in_memory_ = true;
  std::vector<Job> jobs_;
  std::string name_;
  std::ifstream file_;
  std::vector<std::uint64_t> places_;  // where the lines begin
};

}  // namespace blossom::cli
