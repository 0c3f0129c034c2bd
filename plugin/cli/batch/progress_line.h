// SPDX-License-Identifier: LGPL-2.1-or-later
// The line on the terminal that says how far a batch has come, and how long it will take.

#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "plugin/cli/batch/tally.h"

namespace blossom::cli {

/// "12 of 300 jobs, 1 failed; 4.5 a second, 64 s left".
/// done     of `all`; `now` of them in the last `seconds`
std::string progress_text(std::size_t done, std::size_t all, std::size_t failed, std::size_t now,
                          double seconds);

/// Shows it twice a second; silent when stderr is no terminal or with -q.
class ProgressLine {
 public:
  /// open     jobs that are to be done, beside those in the tally
  ProgressLine(std::size_t open, const Tally& tally);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void tick();

 private:
  using Clock = std::chrono::steady_clock;

  const Tally& tally_;
  std::size_t before_;
  std::size_t all_;
  bool silent_;
  bool shown_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_ = start_;
};

}  // namespace blossom::cli
