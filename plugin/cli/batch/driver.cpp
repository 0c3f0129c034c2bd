// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/batch/driver.h"

#include <algorithm>
#include <cctype>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/exchange/modules.h"
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

// Whether a word of a command line names a STEP or IGES file, or something in one.
bool names_exchanged_file(const std::string& word) {
  std::string ending = std::filesystem::path(word.substr(0, word.find('#'))).extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".step" || ending == ".stp" || ending == ".iges" || ending == ".igs";
}

class Driver {
 public:
  Driver(JobList& list, const BatchPolicy& policy, ResultFile& results, Tally& tally,
         std::size_t open)
      : list_(list), policy_(policy), results_(results), tally_(tally), progress_(open, tally) {}

  void begin(Job job, int attempt) {
    load_for(job);
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

  // The libraries for STEP and IGES take longer to load than many jobs take. The first job that
  // names such a file has them loaded here, for all that follow, and they stay theirs where the
  // program is installed anew meanwhile. Batches of other files keep the copies of this process
  // small; jobs whose words do not tell, as of packed files, load what they need themselves.
  void load_for(const Job& job) {
    if (is_loaded_ || std::ranges::none_of(job.arguments, names_exchanged_file)) return;
    is_loaded_ = true;
    try {
      occt::step_module();
      occt::document_module();
    } catch (const occt::Failure&) {  // told by the job
    }
  }

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
  bool is_loaded_ = false;
};

}  // namespace

bool run_jobs(JobList& list, const std::vector<std::size_t>& open, const BatchPolicy& policy,
              ResultFile& results, Tally& tally) {
  return Driver(list, policy, results, tally, open.size()).run(open);
}

}  // namespace blossom::cli
