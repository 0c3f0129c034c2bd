// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/batch/driver.h"

#include <algorithm>
#include <csignal>
#include <ctime>
#include <memory>
#include <string>
#include <utility>

#include "plugin/cli/batch/libraries.h"
#include "plugin/cli/process/interruption.h"

namespace blossom::cli {
namespace {

constexpr timespec kLook{0, 50 * 1000 * 1000};  // at the jobs, when none has ended

// While it lives, ends of processes wait until they are asked for.
class EndsOfProcesses {
 public:
  EndsOfProcesses() {
    sigemptyset(&set_);
    sigaddset(&set_, SIGCHLD);
    sigprocmask(SIG_BLOCK, &set_, &before_);
  }
  ~EndsOfProcesses() { sigprocmask(SIG_SETMASK, &before_, nullptr); }
  EndsOfProcesses(const EndsOfProcesses&) = delete;
  EndsOfProcesses& operator=(const EndsOfProcesses&) = delete;

  /// Until one ends, or a signal comes, or it is time to look.
  void wait() const { sigtimedwait(&set_, nullptr, &kLook); }

 private:
  sigset_t set_{}, before_{};
};

class Driver {
 public:
  Driver(JobList& list, const BatchPolicy& policy, ResultFile& results, Tally& tally,
         std::size_t open)
      : list_(list), policy_(policy), results_(results), tally_(tally), progress_(open, tally) {}

  void begin(Job job, int attempt) {
    // Libraries take longer to load than many jobs take. The first job that names a file which
    // needs one has it loaded here, for all that follow, and it stays theirs where the program is
    // installed anew meanwhile. Batches of other files keep the copies of this process small.
    load(libraries_for(job.arguments), loaded_);
    auto process = std::make_unique<JobProcess>(job, policy_.setup);
    running_.push_back({std::move(job), attempt, std::move(process)});
  }

  bool run(const std::vector<std::size_t>& open) {
    const EndsOfProcesses ends;
    for (std::size_t next = 0; next < open.size() || !running_.empty();) {
      if (interrupted() || !results_.is_wanted()) return false;
      for (; running_.size() < policy_.in_flight && next < open.size(); ++next)
        begin(list_.at(open[next]), 1);
      if (!collect()) ends.wait();
      results_.keep();
      progress_.tick();
    }
    return true;
  }

 private:
  struct Running {
    Job job;
    int attempt;
    std::unique_ptr<JobProcess> process;
  };

  // Whether any has ended.
  bool collect() {
    bool any = false;
    for (auto it = running_.begin(); it != running_.end();) {
      std::optional<Outcome> outcome = it->process->poll();
      if (!outcome) {
        ++it;
        continue;
      }
      any = true;
      Running ended = std::move(*it);
      it = running_.erase(it);
      end(std::move(ended), std::move(*outcome));
    }
    return any;
  }

  void end(Running ended, Outcome outcome) {
    if (outcome.crashed && ended.attempt <= policy_.retries)
      return begin(std::move(ended.job), ended.attempt + 1);
    outcome.attempts = ended.attempt;
    const std::string line = result_line(ended.job, outcome);
    results_.add(line);
    tally_.add(parse_result(line, "result"));
  }

  JobList& list_;
  const BatchPolicy& policy_;
  ResultFile& results_;
  Tally& tally_;
  ProgressLine progress_;
  std::list<Running> running_;
  Libraries loaded_;
};

}  // namespace

bool run_jobs(JobList& list, const std::vector<std::size_t>& open, const BatchPolicy& policy,
              ResultFile& results, Tally& tally) {
  return Driver(list, policy, results, tally, open.size()).run(open);
}

}  // namespace blossom::cli
