// SPDX-License-Identifier: LGPL-2.1-or-later
// One time limit, and one question whether to go on, for many searches that run side by side.

#pragma once

#include <chrono>
#include <mutex>

#include "adapters/occt/base/errors.h"
#include "core/base/work_limit.h"
#include "core/results/options.h"

namespace blossom::occt {

/// The limits of a whole job. Its clock starts when it is made.
class SharedLimit {
 public:
  /// options   the job's; kept by reference
  explicit SharedLimit(const IntersectionOptions& options) : options_(options) {}

  /// Options for one search of the job, with the time that is left. When none is, the search stops
  /// at once, with its place listed. All searches share the threads they run on, and the caller's
  /// function is asked by one of them at a time.
  IntersectionOptions remaining() const;

  /// The same for a step that runs alone: on as many threads as the job.
  IntersectionOptions remaining_alone() const;

  /// Whether no time is left, or the caller wants an end.
  bool is_reached() const;

 private:
  double seconds() const;  // since the clock started

  const IntersectionOptions& options_;
  const std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
  mutable std::mutex asking_;
};

/// Work that follows a search has no time left.
class LimitFailure : public Failure {
 public:
  using Failure::Failure;
};

/// Ends work that follows a search when its limit is reached.
///
/// limit    null: none
/// work     what is being done, in the message
/// throws   LimitFailure
void check_limit(const WorkLimit* limit, const char* work);

}  // namespace blossom::occt
