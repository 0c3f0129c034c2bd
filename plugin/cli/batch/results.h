// SPDX-License-Identifier: LGPL-2.1-or-later
// The file of results: a line for each job, in the order in which they end.
//
// A line is written by one write, behind the others, when its job has ended, and never changed. If
// a write or the machine breaks off, the file ends without an end of line; that piece is cut off
// when the batch goes on, and its job runs again. One batch at a time can have the file.
//
// What is written survives the end of the program, however it comes. Once a second and in the end
// it is brought to the disk: if the machine stops, the jobs of the last second run again.

#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "plugin/cli/batch/outcome.h"

namespace blossom::cli {

class ResultFile {
 public:
  /// Opens the file or makes it, calls use(result) for each line that is there, and cuts off half a
  /// line at the end.
  /// file     or "-" for stdout, which has nothing to begin with
  /// throws   UsageError if a line is no result, or another batch has the file; occt::Failure if it
  ///          cannot be written
  ResultFile(const std::string& file, const std::function<void(const Result&)>& use);
  ~ResultFile();
  ResultFile(const ResultFile&) = delete;
  ResultFile& operator=(const ResultFile&) = delete;

  /// Writes a line.
  /// throws   occt::Failure if it cannot be written; no part of it is left then
  void add(const std::string& line);

  /// False if the results go into a pipe that nobody reads any more.
  bool is_wanted() const;

  /// Brings what is written to the disk, at most once a second unless it has to be now.
  void keep(bool now = false);

 private:
  void read(const std::function<void(const Result&)>& use);

  using Clock = std::chrono::steady_clock;

  std::string name_;
  int descriptor_ = -1;
  bool is_file_ = true;
  bool dirty_ = false;
  Clock::time_point kept_ = Clock::now();
};

}  // namespace blossom::cli
