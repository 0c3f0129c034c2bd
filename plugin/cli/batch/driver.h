// SPDX-License-Identifier: LGPL-2.1-or-later
// Runs the jobs that have no result yet, some at a time.

#pragma once

#include <cstddef>
#include <deque>
#include <list>
#include <vector>

#include "plugin/cli/batch/job_list.h"
#include "plugin/cli/batch/job_process.h"
#include "plugin/cli/batch/progress_line.h"
#include "plugin/cli/batch/results.h"
#include "plugin/cli/batch/tally.h"

namespace blossom::cli {

struct BatchPolicy {
  std::size_t in_flight = 1;  ///< jobs at a time
  int retries = 1;            ///< of a job that crashed
  JobSetup setup;
};

/// Runs the jobs `open` of the list, adds their lines to the results and to the tally.
/// returns  whether all were done; not if the user has asked to stop or nobody reads the results:
/// then what is under way has
///          no result
/// throws   occt::Failure if a result cannot be written
bool run_jobs(JobList& list, const std::vector<std::size_t>& open, const BatchPolicy& policy,
              ResultFile& results, Tally& tally);

}  // namespace blossom::cli
