// SPDX-License-Identifier: LGPL-2.1-or-later
// A line on the terminal that shows that long work is going on.

#pragma once

#include <chrono>
#include <string>

namespace blossom::cli {

/// Shows "intersecting ... 3 s" on stderr once the work has taken a second, and wipes it in the
/// end. Silent when stderr is no terminal or with -q.
class Progress {
 public:
  explicit Progress(std::string doing);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Called now and then by the work.
  void tick();

 private:
  using Clock = std::chrono::steady_clock;

  std::string doing_;
  bool shown_ = false;
  bool silent_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_ = start_ + std::chrono::seconds(1);
};

}  // namespace blossom::cli
