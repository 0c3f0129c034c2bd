// SPDX-License-Identifier: LGPL-2.1-or-later
// What has come of the jobs so far, and the summary of it.

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "plugin/cli/batch/outcome.h"
#include "plugin/cli/output/output.h"

namespace blossom::cli {

inline constexpr std::size_t kMaxListed = 1'000;  ///< jobs of a kind that a report names
inline constexpr std::size_t kMaxSlowest = 10;

class Tally {
 public:
  void add(const Result& result);

  std::size_t count(JobStatus status) const { return of(status).count; }
  std::size_t count() const;

  /// 1 if a job failed, else 4 if one was stopped, else 5 or 3 if a job had that, else 0.
  int exit_code() const;

  /// Lines for each kind that there is: how many are done and not complete, or have findings;
  /// "failed: 2 jobs", and the first few of them, or with `all` as many as are known.
  std::string text(bool all) const;

  /// Members "jobs", "done", "tolerance", "findings", "stopped", "failed", "slowest".
  Json json() const;

 private:
  struct Kind {
    std::size_t count = 0;
    std::vector<Result> first;  // kMaxListed at most
  };
  const Kind& of(JobStatus status) const { return kinds_[static_cast<std::size_t>(status)]; }

  Kind kinds_[3];
  std::vector<Result> slowest_;               // the slowest first
  std::size_t findings_ = 0, tolerance_ = 0;  // jobs that are done with these exit codes
};

}  // namespace blossom::cli
