// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/batch/job_process.h"

#include <fcntl.h>
#include <oneapi/tbb/global_control.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstring>
#include <iostream>
#include <new>
#include <set>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/kept_models.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/output/verbosity.h"
#include "plugin/cli/process/reproduction.h"
#include "plugin/cli/process/supervision.h"

namespace blossom::cli {
namespace {

// The job ends itself at its limit; what is still there then, and later by all that writing may
// take (see supervised), hangs.
constexpr double kLateShare = 0.2, kLateSeconds = 3;
constexpr double kMegabyte = 1e6;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// A file without a name, of this process and its copies.
int memory_file() {
  const int descriptor = memfd_create("blossom", MFD_CLOEXEC);
  if (descriptor < 0) throw occt::Failure(std::string("no job can begin: ") + std::strerror(errno));
  return descriptor;
}

std::string text_of(int descriptor, long most) {
  struct stat facts {};
  if (fstat(descriptor, &facts) != 0) return {};
  std::string text(static_cast<std::size_t>(std::min<long>(facts.st_size, most)), '\0');
  const ssize_t length = pread(descriptor, text.data(), text.size(), 0);
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(length, 0)));
  return text;
}

void limit_data(double megabytes) {
  if (!(megabytes > 0)) return;
  const auto bytes = static_cast<rlim_t>(megabytes * kMegabyte);
  const rlimit limit{bytes, bytes};
  setrlimit(RLIMIT_DATA, &limit);
}

// Signals as a program finds them at its start.
void reset_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGCHLD}) std::signal(signal, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
}

// Commands that change no model that they read.
bool only_looks(const Job& job) {
  static const std::set<std::string> kLooking = {"check",     "clash", "info",
                                                 "intersect", "query", "self-intersect"};
  return kLooking.contains(job.arguments.front());
}

Ended ended(const Job& job, const JobSetup& setup, const std::function<void(const Ended&)>& told) {
  if (!only_looks(job)) occt::keep_models_in({}, {});
  std::vector<std::string> words{"blossom"};
  words.insert(words.end(), job.arguments.begin(), job.arguments.end());
  const auto program = [&](int argc, char** argv) {
    using oneapi::tbb::global_control;
    const global_control control(global_control::max_allowed_parallelism,
                                 static_cast<std::size_t>(setup.threads));
    return setup.program(argc, argv);
  };
  return run_reproducibly(words, program, told);
}

}  // namespace

struct JobProcess::Shared {
  std::atomic<bool> has_ended{false};  // what follows has a limit of its own, see reproduction.h
  std::atomic<bool> crashed{false};
  std::atomic<bool> lacked_memory{false};
};

JobProcess::JobProcess(const Job& job, const JobSetup& setup)
    : setup_(setup), out_(memory_file()), err_(memory_file()) {
  void* const memory =
      mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
  shared_ = new (memory) Shared;
  std::cout.flush();
  const pid_t parent = getpid();
  process_ = fork();
  if (process_ < 0) throw occt::Failure(std::string("no job can begin: ") + std::strerror(errno));
  if (process_ == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(kExitFailure);
    work(job);
  }
  setpgid(process_, process_);  // as the job's process does itself: whoever comes first
}

JobProcess::~JobProcess() {
  if (process_ > 0) {
    kill(-process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  if (shared_ != nullptr) munmap(shared_, sizeof(Shared));
  for (const int descriptor : {out_, err_}) close(descriptor);
}

void JobProcess::work(const Job& job) const {
  setpgid(0, 0);
  reset_signals();
  const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
  dup2(nothing, STDIN_FILENO);
  dup2(out_, STDOUT_FILENO);
  dup2(err_, STDERR_FILENO);
  close_range(STDERR_FILENO + 1, UINT_MAX, 0);  // the results, and the lock on them
  if (!setup_.folder.empty() && chdir(setup_.folder.c_str()) != 0) _exit(kExitFailure);
  limit_data(setup_.megabytes);
  set_verbosity(Verbosity::Normal);
  if (setup_.seconds > 0) set_greatest_time_limit(setup_.seconds);
  const Ended end = ended(job, setup_, [this](const Ended&) { shared_->has_ended = true; });
  shared_->crashed = end.how.crashed;
  shared_->lacked_memory = end.how.lacked_memory;
  _exit(end.code);
}

void JobProcess::stop_beyond_limits() {
  struct stat facts {};
  const double limit = setup_.seconds;
  if (!stopped_for_.empty()) return;
  if (limit > 0 && !shared_->has_ended &&
      seconds_since(start_) > limit * (1 + kLateShare) + kLateSeconds)
    stopped_for_ = "it did not end at the time limit";
  else if (fstat(out_, &facts) == 0 && facts.st_size > kMaxJobOutput)
    stopped_for_ = "it writes more than " + std::to_string(kMaxJobOutput) + " bytes to stdout";
  if (!stopped_for_.empty()) kill(-process_, SIGKILL);
}

std::optional<Outcome> JobProcess::poll() {
  int status = 0;
  rusage used{};
  const pid_t ended = wait4(process_, &status, WNOHANG, &used);
  if (ended == 0) {
    stop_beyond_limits();
    return std::nullopt;
  }
  process_ = -1;
  return outcome(status, 1024 * static_cast<double>(used.ru_maxrss) / kMegabyte);
}

Outcome JobProcess::outcome(int status, double megabytes) const {
  Outcome outcome;
  outcome.seconds = seconds_since(start_);
  outcome.memory = megabytes;
  outcome.out = text_of(out_, kMaxJobOutput);
  outcome.err = text_of(err_, kMaxJobMessages);
  const bool refused = setup_.megabytes > 0 && shared_->lacked_memory;
  outcome.crashed = !refused && (shared_->crashed || (WIFSIGNALED(status) && stopped_for_.empty()));
  const auto say = [&](const std::string& text) { outcome.err += "blossom: " + text + "\n"; };
  if (!stopped_for_.empty()) {
    say("the job was stopped: " + stopped_for_);
    outcome.code = kExitStopped;
  } else if (WIFSIGNALED(status)) {
    say("the job was ended by the signal " + std::to_string(WTERMSIG(status)));
    outcome.code = kExitFailure;
  } else {
    outcome.code = WEXITSTATUS(status);
  }
  if (refused) say("the job was stopped: it wants more memory than its limit");
  if (outcome.code == kExitStopped || refused)
    outcome.status = JobStatus::Stopped;
  else if (outcome.code == kExitComplete || outcome.code == kExitTolerance ||
           outcome.code == kExitFindings)
    outcome.status = JobStatus::Done;
  return outcome;
}

}  // namespace blossom::cli
