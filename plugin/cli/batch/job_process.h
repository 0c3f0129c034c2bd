// SPDX-License-Identifier: LGPL-2.1-or-later
// A job at work, in processes of its own.
//
// The job's process is a copy of this one, so that the program's start of some 60 ms is paid once
// for all; what it does is what the program does for such a command line (see supervision.h). It
// leads a group of processes that gets none of the terminal's signals and ends with this process,
// however that ends. It reads nothing from stdin; what it writes to stdout and stderr is kept in
// memory.

#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>

#include "plugin/cli/batch/job.h"
#include "plugin/cli/batch/outcome.h"
#include "plugin/cli/program.h"

namespace blossom::cli {

/// How a job works.
struct JobSetup {
  int (*program)(int argc, char** argv) = run_program;  ///< what its arguments are for

  double seconds = 0;    ///< for a job; 0 for none
  double megabytes = 0;  ///< of data that a job may have; 0 for what the machine has
  int threads = 1;       ///< at most, whatever the job says
  std::string folder;    ///< where it works; empty for this folder
  std::string cache;     ///< folder of models kept for other jobs, see kept_models.h; or empty
};

inline constexpr long kMaxJobOutput = 1L << 28;    ///< bytes on stdout; more stops the job
inline constexpr long kMaxJobMessages = 1L << 20;  ///< bytes on stderr; the rest is dropped

class JobProcess {
 public:
  /// Begins.
  /// throws   occt::Failure if there can be no process
  JobProcess(const Job& job, const JobSetup& setup);
  /// Ends what is left of it.
  ~JobProcess();
  JobProcess(const JobProcess&) = delete;
  JobProcess& operator=(const JobProcess&) = delete;

  /// The outcome, once the job has ended; ends a job that is beyond a limit.
  std::optional<Outcome> poll();

 private:
  struct Shared;
  [[noreturn]] void work(const Job& job) const;
  void stop_beyond_limits();
  Outcome outcome(int status, double megabytes) const;

  using Clock = std::chrono::steady_clock;

  JobSetup setup_;
  Clock::time_point start_ = Clock::now();
  Shared* shared_ = nullptr;  // what the job's process tells at its end
  int out_ = -1, err_ = -1;   // files in memory
  pid_t process_ = -1;        // -1 when it has ended
  std::string stopped_for_;   // why it was ended
};

}  // namespace blossom::cli
