// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/process/supervision.h"

#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <exception>
#include <iostream>
#include <new>
#include <optional>
#include <set>
#include <span>
#include <sstream>

#include "core/base/sanitizers.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/cli/process/stages.h"

namespace blossom::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kGrace = 0.8;                  // seconds between the time limit and killing
constexpr double kGraceAsked = 0.5;             // likewise, when the user wants the end
constexpr double kWritingShare = 0.1;           // of the limit, for writing after it
constexpr timespec kTick{0, 20 * 1000 * 1000};  // between two looks at the work

constexpr std::size_t kMaxLines = 256;  // that are known when the work begins again

double greatest_limit = 0;  // seconds; 0 for none
bool work_crashed = false;
std::terminate_handler uncaught_as_ever = std::abort;

/// What the work tells its parent, in memory of both, and of those that begin again.
struct Board {
  std::atomic<double> time_limit{0};       // seconds from the start; 0 for none
  std::atomic<double> processor_limit{0};  // processor seconds of the child; 0 for none
  std::atomic<Phase> phase{Phase::Starting};
  std::atomic<bool> lacks_memory{false};  // for good: what begins again may have left out something
  std::atomic<bool> told_lack{false};     // of memory, where nobody could catch it
  // Read after the end of the child only.
  char subject[4096] = "";
  char step[4096] = "";
  // Hashes of lines that were said.
  std::array<std::size_t, kMaxLines> said{};
  std::size_t lines = 0;

  void begin() {
    time_limit = greatest_limit;
    processor_limit = 0;
    phase = Phase::Starting;
    subject[0] = step[0] = '\0';
  }
};
static_assert(std::atomic<double>::is_always_lock_free && std::atomic<Phase>::is_always_lock_free);

Clock::time_point started = Clock::now();
Board* board = nullptr;
std::set<std::string> failed_steps;  // optional steps; known to children made later

double now() { return std::chrono::duration<double>(Clock::now() - started).count(); }

double seconds_of(const timespec& time) {
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double processor_seconds(clockid_t clock) {
  timespec time{};
  return clock_gettime(clock, &time) == 0 ? seconds_of(time) : 0;
}

Board* new_board() {
  void* const memory =
      mmap(nullptr, sizeof(Board), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  return memory == MAP_FAILED ? nullptr : new (memory) Board;
}

/// Asking for more memory than the machine has is an error of the work instead of the machine's
/// end. Sanitizers ask for far more than they use.
void limit_memory() {
#if !defined(BLOSSOM_ADDRESS_SANITIZER)
  const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE);
  rlimit limit{};
  if (pages <= 0 || size <= 0 || getrlimit(RLIMIT_DATA, &limit) != 0) return;
  limit.rlim_cur =
      std::min<rlim_t>(limit.rlim_max, static_cast<rlim_t>(pages) * static_cast<rlim_t>(size));
  setrlimit(RLIMIT_DATA, &limit);
#endif
}

/// While it lives, the parent's signals wait until they are asked for.
class WatchedSignals {
 public:
  WatchedSignals() {
    sigemptyset(&set_);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGCHLD}) sigaddset(&set_, signal);
    pthread_sigmask(SIG_BLOCK, &set_, &before_);
    // Who is started in the background may have inherited that these are ignored.
    for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_DFL);
  }
  ~WatchedSignals() { release(); }
  WatchedSignals(const WatchedSignals&) = delete;
  WatchedSignals& operator=(const WatchedSignals&) = delete;

  const sigset_t& set() const { return set_; }

  /// Lets them through to whoever handles them.
  void release() const { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t set_{}, before_{};
};

const char* name_of_signal(int signal) {
  switch (signal) {
    case SIGSEGV:
    case SIGBUS: return "an invalid memory access";
    case SIGFPE: return "an arithmetic fault";
    case SIGABRT: return "a failed internal check";
    case SIGKILL: return "ended by the system, perhaps for want of memory";
    default: return strsignal(signal);
  }
}

/// The parent's side of one child.
class Watch {
 public:
  explicit Watch(pid_t child) : child_(child) {
    if (clock_getcpuclockid(child, &clock_) != 0) clock_ = CLOCK_MONOTONIC;
  }

  /// Waits for the end of the child and says what was not as it should be.
  /// returns  the exit code; nothing if the work is to begin again without an optional step
  std::optional<int> finish(const sigset_t& signals) {
    int status = 0;
    while (waitpid(child_, &status, WNOHANG) != child_) {
      siginfo_t told{};
      const int signal = sigtimedwait(&signals, &told, &kTick);
      if (signal > 0 && signal != SIGCHLD) ask(told);
      if (!killed_for_ && (killed_for_ = overdue())) kill(child_, SIGKILL);
    }
    end_stages(told(status));
    if (WIFEXITED(status)) return WEXITSTATUS(status);
    if (asked_) return ended_late(Reason::Asked);  // it does not begin again, whatever ended it
    const bool wanted = killed_for_ && *killed_for_ != Reason::ProcessorLimit;
    if (board->phase == Phase::Optional && !wanted && failed_steps.insert(doing()).second)
      return std::nullopt;
    return killed_for_ ? ended_late(*killed_for_) : crashed(WTERMSIG(status));
  }

 private:
  enum class Reason { Asked, TimeLimit, ProcessorLimit };

  std::string told(int status) const {
    if (WIFEXITED(status)) return "exit code " + std::to_string(WEXITSTATUS(status));
    return killed_for_ ? "ended at a limit" : name_of_signal(WTERMSIG(status));
  }

  /// A terminal sends its signals to the child, too; others reach only the parent.
  void ask(const siginfo_t& told) {
    if (told.si_code <= 0) kill(child_, SIGTERM);
    if (!asked_) asked_ = now();
  }

  std::optional<Reason> overdue() const {
    if (asked_ && now() > *asked_ + kGraceAsked) return Reason::Asked;
    const Phase phase = board->phase;
    const bool bounded = phase == Phase::Reading || phase == Phase::Optional;
    const double limit = board->time_limit, processor_limit = board->processor_limit;
    const double grace = phase == Phase::Writing ? std::max(kGrace, kWritingShare * limit) : kGrace;
    if (limit > 0 && phase != Phase::Placing && now() > limit + grace) return Reason::TimeLimit;
    if (bounded && !(limit > 0) && processor_limit > 0 &&
        processor_seconds(clock_) > processor_limit)
      return Reason::ProcessorLimit;
    return std::nullopt;
  }

  int ended_late(Reason reason) const;
  std::optional<int> crashed(int signal) const;

  pid_t child_;
  clockid_t clock_{};
  std::optional<double> asked_;  // when the user wanted the end
  std::optional<Reason> killed_for_;
};

void announce(const std::string& text) { std::cerr << "blossom: " << text << std::endl; }

int Watch::ended_late(Reason reason) const {
  std::ostringstream text;
  switch (reason) {
    case Reason::Asked: announce(Interrupted().what()); return kExitInterrupted;
    case Reason::TimeLimit:
      text << "the time limit of " << board->time_limit << " s was reached while " << doing()
           << (board->phase == Phase::Writing ? ", which is not done" : ", nothing was written");
      announce(text.str());
      return kExitStopped;
    case Reason::ProcessorLimit: break;
  }
  text << board->subject << ": reading it takes more than " << board->processor_limit
       << " s of processor time, which no sound file of its size does; --time-limit allows more";
  announce(text.str());
  return kExitBadInput;
}

std::optional<int> Watch::crashed(int signal) const {
  if (signal == SIGPIPE) {  // nobody reads what the command says
    std::signal(SIGPIPE, SIG_DFL);
    raise(SIGPIPE);
  }
  work_crashed = true;
  const Phase phase = board->phase;
  if (phase == Phase::Reading) {
    announce(board->subject + (": cannot be read: Open CASCADE crashes while " + doing() + " (" +
                               name_of_signal(signal) + ")"));
    return kExitBadInput;
  }
  announce("internal error: the program crashed while " + doing() + " (" + name_of_signal(signal) +
           "); please report it with the command and its inputs");
  return kExitFailure;
}

/// Whether not even a thread's stack can be had.
bool lacks_stack() {
  constexpr std::size_t kStack = 8 << 20;  // bytes, what systems give a thread
  void* const memory =
      mmap(nullptr, kStack, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory != MAP_FAILED) munmap(memory, kStack);
  return memory == MAP_FAILED;
}

/// Of an exception that nobody can catch, as where a library starts its threads: want of memory is
/// no fault of the program.
[[noreturn]] void end_uncaught() {
  bool lacks_memory = lacks_stack();
  try {
    if (const std::exception_ptr thrown = std::current_exception()) std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
    lacks_memory = true;
  } catch (...) {
  }
  if (!lacks_memory) uncaught_as_ever();
  board->lacks_memory = true;
  if (board->told_lack.exchange(true)) _exit(kExitFailure);  // by another thread
  const auto say = [](const char* words) {
    if (write(STDERR_FILENO, words, std::strlen(words)) < 0) _exit(kExitFailure);
  };
  say("blossom: there is not enough memory for ");
  say(board->step[0] != '\0' ? board->step : board->subject);
  say("\n");
  _exit(kExitFailure);
}

/// What the child does.
[[noreturn]] void work_as_child(const std::function<int()>& work, pid_t parent,
                                const WatchedSignals& signals) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(kExitFailure);
  limit_memory();
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large cannot be written, which is told
  uncaught_as_ever = std::set_terminate(end_uncaught);
  watch_for_interruption();
  signals.release();
  std::exit(work());
}

template <std::size_t size>
void put(const std::string& text, char (&place)[size]) {
  place[text.copy(place, size - 1)] = '\0';
}

}  // namespace

int supervised(const std::function<int()>& work) {
  started = Clock::now();
  const WatchedSignals signals;
  const pid_t parent = getpid();
  board = new_board();
  work_crashed = false;
  share_stages();
  while (true) {
    if (board != nullptr) board->begin();
    const pid_t child = board == nullptr ? -1 : fork();
    if (child == 0) work_as_child(work, parent, signals);
    if (child < 0) {
      watch_for_interruption();
      signals.release();
      return work();
    }
    if (const std::optional<int> code = Watch(child).finish(signals.set())) return *code;
  }
}

void enter(Phase phase, const std::string& subject, const std::string& step) {
  if (board == nullptr) return;
  put(subject, board->subject);
  put(step, board->step);
  board->phase = phase;
  begin_stage(doing());
}

std::string doing() {
  if (board == nullptr) return "starting";
  if (board->step[0] != '\0') return board->step;
  const std::string subject = board->subject;
  switch (board->phase.load()) {
    case Phase::Starting: return "starting";
    case Phase::Reading: return "reading " + subject;
    case Phase::Optional: break;
    case Phase::Writing:
    case Phase::Placing: return "writing " + subject;
    case Phase::Working: break;
  }
  return subject;
}

Ending last_ending() { return {work_crashed, board != nullptr && board->lacks_memory}; }

void report_lack_of_memory() {
  if (board != nullptr) board->lacks_memory = true;
}

void set_greatest_time_limit(double seconds) { greatest_limit = seconds; }

double greatest_time_limit() { return greatest_limit; }

void set_time_limit(double seconds) {
  if (board == nullptr) return;
  board->time_limit = greatest_limit > 0 ? std::min(seconds, greatest_limit) : seconds;
}

double seconds_left() {
  if (board == nullptr || !(board->time_limit > 0)) return 0;
  return std::max(1e-6, board->time_limit - now());
}

void allow_processor_time(double seconds) {
  if (board != nullptr)
    board->processor_limit = processor_seconds(CLOCK_PROCESS_CPUTIME_ID) + seconds;
}

bool is_news(const std::string& line) {
  if (board == nullptr) return true;
  const std::span<const std::size_t> said(board->said.data(), board->lines);
  const std::size_t hash = std::hash<std::string>{}(line);
  if (std::ranges::find(said, hash) != said.end()) return false;
  if (board->lines < kMaxLines) board->said[board->lines++] = hash;
  return true;
}

bool has_failed(const std::string& step) { return failed_steps.contains(step); }

}  // namespace blossom::cli
