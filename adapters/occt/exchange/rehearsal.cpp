// SPDX-License-Identifier: LGPL-2.1-or-later
// What must not end a program is read in a child process before the program reads it itself.

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <mutex>
#include <new>
#include <string>
#include <string_view>
#include <utility>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/exchange/brep_bytes.h"
#include "adapters/occt/exchange/detail.h"
#include "adapters/occt/reading.h"
#include "adapters/occt/shapes.h"

extern "C" {  // which the header of glibc 2.36 forgets
#include <sys/pidfd.h>
}

namespace blossom::occt {
namespace {

constexpr int kPause = 20;  // milliseconds between two questions whether to go on

/// What the child tells, in memory of both.
struct Board {
  char step[4096] = "opening";
  bool finished = false;
};

class SharedBoard {
 public:
  SharedBoard()
      : memory_(mmap(nullptr, sizeof(Board), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1,
                     0)),
        board_(memory_ == MAP_FAILED ? nullptr : new (memory_) Board) {}
  ~SharedBoard() {
    if (board_ != nullptr) munmap(memory_, sizeof(Board));
  }
  SharedBoard(const SharedBoard&) = delete;
  SharedBoard& operator=(const SharedBoard&) = delete;
  Board* get() const { return board_; }

 private:
  void* memory_;
  Board* board_;
};

/// A process that ends with its owner at the latest.
class Child {
 public:
  explicit Child(pid_t id) : id_(id), handle_(pidfd_open(id, 0)) {}
  ~Child() {
    if (!ended_) {
      kill(id_, SIGKILL);
      waitpid(id_, &status_, 0);
    }
    if (handle_ >= 0) close(handle_);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// The signal that ended it; 0 if none did, or another part of the program has waited for it.
  int wait(const std::function<void()>& stop) {
    while (!ended_) {
      const pid_t told = waitpid(id_, &status_, WNOHANG);
      ended_ = told == id_ || (told < 0 && errno == ECHILD);
      if (ended_) return told == id_ && WIFSIGNALED(status_) ? WTERMSIG(status_) : 0;
      pollfd end{handle_, POLLIN, 0};
      poll(&end, 1, kPause);
      if (stop) stop();
    }
    return 0;
  }

 private:
  pid_t id_;
  int handle_, status_ = 0;
  bool ended_ = false;
};

void limit(__rlimit_resource resource, rlim_t most) {
  rlimit bounds{};
  if (getrlimit(resource, &bounds) != 0) return;
  bounds.rlim_cur = std::min(bounds.rlim_max, most);
  setrlimit(resource, &bounds);
}

/// What the program does in a crash, and with what is printed, is no business of its child.
void leave_the_program_alone(rlim_t processor_seconds) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU, SIGTERM, SIGINT})
    std::signal(signal, SIG_DFL);
  if (const int nowhere = open("/dev/null", O_RDWR); nowhere >= 0)
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, processor_seconds);
#if !defined(__SANITIZE_ADDRESS__)
  const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE);
  if (pages > 0 && size > 0)
    limit(RLIMIT_DATA, static_cast<rlim_t>(pages) * static_cast<rlim_t>(size));
#endif
}

using Step = std::function<void(const char* step)>;
using Reader = std::function<void(const Step&)>;  // says what it does

[[noreturn]] void read_as_child(const Reader& read, rlim_t processor_seconds, Board& board) {
  leave_the_program_alone(processor_seconds);
  new (&exchange_lock()) std::recursive_mutex;  // whose owner there is not here
  try {
    read([&board](const char* step) {
      board.step[std::string_view(step).copy(board.step, sizeof(board.step) - 1)] = '\0';
    });
  } catch (...) {  // who reads it after this is told the same
  }
  board.finished = true;
  _exit(0);
}

/// How reading ended.
struct Rehearsal {
  bool finished = true;
  bool overdue = false;  ///< it took more processor time than it may
  std::string step{};    ///< that it was at
};

Rehearsal rehearse(const Reader& read, rlim_t processor_seconds,
                   const std::function<void()>& stop) {
  const SharedBoard shared;
  Board* const board = shared.get();
  if (board == nullptr) return {};
  pid_t id = -1;
  {
    const std::lock_guard nobody_reads(exchange_lock());
    id = fork();
  }
  if (id == 0) read_as_child(read, processor_seconds, *board);
  if (id < 0) return {};
  const int signal = Child(id).wait(stop);
  return {board->finished, signal == SIGXCPU, board->step};
}

/// Processor seconds for so many bytes that are not packed.
double allowance(double bytes) { return 1 + 1.5e-5 * bytes; }

rlim_t whole_seconds(double seconds) { return static_cast<rlim_t>(std::ceil(seconds)); }

[[noreturn]] void refuse_unfinished(const std::string& name, const Rehearsal& done,
                                    rlim_t processor_seconds) {
  if (!done.overdue)
    throw BadModel(name + ": cannot be read: Open CASCADE crashes while " + done.step);
  throw BadModel(name + ": reading it takes more than " + std::to_string(processor_seconds) +
                 " s of processor time, which nothing sound of its size does");
}

}  // namespace

double reading_allowance(const std::filesystem::path& file) {
  std::error_code error;
  const auto bytes = static_cast<double>(std::filesystem::file_size(file, error));
  const std::string ending = file.extension().string();
  const bool packed =
      ending.ends_with('z') || ending.ends_with('Z') || ending == ".zip" || ending == ".ZIP";
  return error ? 1 : allowance(packed ? 10 * bytes : bytes);
}

ReadOptions rehearsed(const std::filesystem::path& file, ReadOptions options,
                      const std::function<void()>& stop) {
  const rlim_t seconds = whole_seconds(reading_allowance(file));
  while (true) {
    ReadOptions tried = options;
    const Rehearsal done = rehearse(
        [&](const Step& step) {
          tried.step = step;
          read_model(file, tried);
        },
        seconds, stop);
    if (done.finished) return options;
    if (done.step.starts_with(kReadingNames) && std::exchange(options.names, false)) continue;
    if (done.step.starts_with(kMakingDamaged) && std::exchange(options.damaged, false)) continue;
    refuse_unfinished(file.string(), done, seconds);
  }
}

TopoDS_Shape rehearsed_shape_from_bytes(std::string_view bytes, const std::string& name,
                                        const std::function<void()>& stop) {
  const rlim_t seconds = whole_seconds(allowance(static_cast<double>(bytes.size())));
  const Rehearsal done = rehearse(
      [&](const Step& step) {
        step("reading the shapes");
        shape_from_bytes(bytes, name);
      },
      seconds, stop);
  if (!done.finished) refuse_unfinished(name, done, seconds);
  return shape_from_bytes(bytes, name);
}

}  // namespace blossom::occt
