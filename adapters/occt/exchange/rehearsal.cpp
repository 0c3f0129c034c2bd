// SPDX-License-Identifier: LGPL-2.1-or-later
// What must not end a program is read in a child process, which hands over what it has read.

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
#include <cstddef>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <ios>
#include <mutex>
#include <new>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include <Standard_Failure.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/exact/exact_bytes.h"
#include "adapters/occt/exchange/brep_bytes.h"
#include "adapters/occt/exchange/detail.h"
#include "adapters/occt/exchange/model_bytes.h"
#include "adapters/occt/reading.h"
#include "core/base/sanitizers.h"
#include "adapters/occt/shapes.h"

extern "C" {  // which the header of glibc 2.36 forgets
#include <sys/pidfd.h>
}

namespace blossom::occt {
namespace {

constexpr int kPause = 20;  // milliseconds between two questions whether to go on

// Pauses in a row, 3 s, in which a child that reads uses no processor time: it then waits for what
// never comes, a lock that another thread of the program held when the child was made. Nothing else
// lets it sleep but the disk, which answers in hundredths of a second. Pauses are counted, not the
// time, so that a program that is stopped for a while takes no child for stuck.
constexpr int kPausesOfStuck = 3000 / kPause;

/// What the child tells, in memory of both.
struct Board {
  char step[4096] = "opening";
  char fault[4096] = "";  ///< of what is read, in words
  bool finished = false;
  bool lacks_memory = false;
  bool handed_over = false;
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
  explicit Child(pid_t id) : id_(id), handle_(pidfd_open(id, 0)) {
    if (clockid_t clock{}; clock_getcpuclockid(id, &clock) == 0) clock_ = clock;
  }
  ~Child() {
    if (!ended_) {
      kill(id_, SIGKILL);
      waitpid(id_, &status_, 0);
    }
    if (handle_ >= 0) close(handle_);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// The signal that ended it; 0 if none did, or another part of the program has waited for it;
  /// nothing if it is stuck.
  std::optional<int> wait(const std::function<void()>& stop) {
    timespec used = processor_time();
    for (int still = 0; still < kPausesOfStuck;) {
      const pid_t told = wait4(id_, &status_, WNOHANG, &used_);
      ended_ = told == id_ || (told < 0 && errno == ECHILD);
      if (stop) stop();  // also after its end: what interrupts both is no fault of what is read
      if (ended_) return told == id_ && WIFSIGNALED(status_) ? WTERMSIG(status_) : 0;
      pollfd end{handle_, POLLIN, 0};
      if (poll(&end, 1, kPause) != 0) continue;
      const timespec now = processor_time();
      still = clock_ && now.tv_sec == used.tv_sec && now.tv_nsec == used.tv_nsec ? still + 1 : 0;
      used = now;
    }
    return std::nullopt;
  }

  /// The most that it had in memory, with what it got from the program; bytes. After its end.
  std::size_t memory() const { return 1024 * static_cast<std::size_t>(used_.ru_maxrss); }

 private:
  timespec processor_time() {
    timespec used{};
    if (clock_ && clock_gettime(*clock_, &used) != 0) clock_.reset();
    return used;
  }

  pid_t id_;
  int handle_, status_ = 0;
  rusage used_{};
  std::optional<clockid_t> clock_{};
  bool ended_ = false;
};

void limit(__rlimit_resource resource, rlim_t most) {
  rlimit bounds{};
  if (getrlimit(resource, &bounds) != 0) return;
  bounds.rlim_cur = std::min(bounds.rlim_cur, most);
  setrlimit(resource, &bounds);
}

/// What the program does in a crash, and with what is printed, is no business of its child. What
/// interrupts both, as from a terminal, is for the program, and it ends the child.
void leave_the_program_alone(rlim_t processor_seconds) {
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU})
    std::signal(signal, SIG_DFL);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGQUIT}) std::signal(signal, SIG_IGN);
  if (const int nowhere = open("/dev/null", O_RDWR); nowhere >= 0)
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, processor_seconds);
#if !defined(BLOSSOM_ADDRESS_SANITIZER)
  const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE);
  if (pages > 0 && size > 0)
    limit(RLIMIT_DATA, static_cast<rlim_t>(pages) * static_cast<rlim_t>(size));
#endif
}

using Step = std::function<void(const char* step)>;

/// What a child does.
struct Reader {
  std::function<void(const Step&)> read;                  ///< says what it does
  std::function<std::optional<std::string>()> hand_over;  ///< what it has read, as bytes if it can
};

/// A file without a name, which goes with its last owner.
class Parcel {
 public:
  Parcel() : file_(memfd_create("blossom", MFD_CLOEXEC)) {}
  ~Parcel() {
    if (file_ >= 0) close(file_);
  }
  Parcel(const Parcel&) = delete;
  Parcel& operator=(const Parcel&) = delete;

  /// Whether all of it is there then.
  bool put(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t written = write(file_, bytes.data(), bytes.size());
      if (written <= 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
  }

  std::string taken() const {
    const off_t size = lseek(file_, 0, SEEK_END);
    std::string bytes(static_cast<std::size_t>(std::max<off_t>(size, 0)), '\0');
    for (std::size_t at = 0; at < bytes.size();) {
      const ssize_t got =
          pread(file_, bytes.data() + at, bytes.size() - at, static_cast<off_t>(at));
      if (got <= 0) throw std::ios_base::failure("what was read cannot be taken over");
      at += static_cast<std::size_t>(got);
    }
    return bytes;
  }

 private:
  int file_;
};

/// What cannot be handed over is read again, if there is memory for that.
void hand_over(const Reader& reader, const Parcel& parcel, Board& board) {
  try {
    const std::optional<std::string> bytes = reader.hand_over();
    board.handed_over = bytes && parcel.put(*bytes);
  } catch (...) {
    board.lacks_memory = is_lack_of_memory();
  }
}

Board* board_of_child = nullptr;  // set there alone

/// Open CASCADE's destructors throw for want of memory, which nobody can catch.
[[noreturn]] void end_uncaught() {
  board_of_child->lacks_memory = is_lack_of_memory();
  std::abort();
}

template <std::size_t size>
void put(std::string_view text, char (&place)[size]) {
  place[text.copy(place, size - 1)] = '\0';
}

[[noreturn]] void read_as_child(const Reader& reader, rlim_t processor_seconds, pid_t parent,
                                Board& board, const Parcel& parcel) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(0);
  leave_the_program_alone(processor_seconds);
  new (&exchange_lock()) std::recursive_mutex;  // whose owner there is not here
  board_of_child = &board;
  std::set_terminate(end_uncaught);
  bool is_read = false;
  try {
    reader.read([&board](const char* step) { put(step, board.step); });
    is_read = true;
  } catch (const BadModel& bad) {
    put(bad.what(), board.fault);
  } catch (...) {  // other failures are told when it is read after this
    board.lacks_memory = is_lack_of_memory();
  }
  board.finished = true;
  if (is_read) hand_over(reader, parcel, board);
  _exit(0);
}

/// How reading ended.
struct Rehearsal {
  bool finished = true;
  bool overdue = false;    ///< it took more processor time than it may
  std::string step{};      ///< that it was at
  std::size_t memory = 0;  ///< that it took, bytes
  std::optional<std::string> handed_over{};
};

/// Where no process can be made, or the one that is made gets stuck, it is as if reading had ended.
/// Not for want of memory: reading would then end the program.
/// throws   std::bad_alloc if the child lacks memory, of its own or as the system ends it for that;
///          BadModel as it reads: where memory is short, Open CASCADE takes that for a fault
Rehearsal rehearse(const Reader& reader, rlim_t processor_seconds,
                   const std::function<void()>& stop) {
  const SharedBoard shared;
  const Parcel parcel;
  Board* const board = shared.get();
  if (board == nullptr) throw std::bad_alloc();
  const pid_t parent = getpid();
  pid_t id = -1;
  {
    const std::lock_guard nobody_reads(exchange_lock());
    id = fork();
  }
  if (id == 0) read_as_child(reader, processor_seconds, parent, *board, parcel);
  if (id < 0 && errno == ENOMEM) throw std::bad_alloc();
  if (id < 0) return {};
  Child child(id);
  const std::optional<int> signal = child.wait(stop);
  if (!signal) return {};
  if (board->handed_over && signal == 0)
    return {.memory = child.memory(), .handed_over = parcel.taken()};
  if (signal == SIGKILL || board->lacks_memory) throw std::bad_alloc();
  if (board->finished && board->fault[0] != '\0') throw BadModel(board->fault);
  return {board->finished, signal == SIGXCPU, board->step, child.memory()};
}

/// Before the program does what a child did: want of memory in it may end the program, as Open
/// CASCADE's destructors throw then.
/// throws   std::bad_alloc if it cannot have as much
void make_sure_of(std::size_t memory) {
  if (memory == 0) return;
  void* const there = mmap(nullptr, memory, PROT_READ | PROT_WRITE,
                           MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (there == MAP_FAILED) throw std::bad_alloc();
  munmap(there, memory);
}

/// What the bytes of a child give; nothing where they give none: then it is read again.
template <class Take>
auto taken_over(const Take& take) -> std::optional<decltype(take())> {
  try {
    return take();
  } catch (const Standard_Failure&) {
    if (is_lack_of_memory()) throw std::bad_alloc();
  } catch (const std::ios_base::failure&) {
  }
  return std::nullopt;
}

rlim_t whole_seconds(double seconds) { return static_cast<rlim_t>(std::ceil(seconds)); }

[[noreturn]] void refuse_unfinished(const std::string& name, const Rehearsal& done,
                                    rlim_t processor_seconds) {
  if (!done.overdue)
    throw BadModel(name + ": cannot be read: Open CASCADE crashes while " + done.step);
  throw BadModel(name + ": reading it takes more than " + std::to_string(processor_seconds) +
                 " s of processor time, which nothing sound of its size does");
}

constexpr std::string_view kReadingParts = "reading parts from ";

/// What a child is not to do, since another one did not come to its end there.
struct Avoided {
  bool names = false, damaged = false;
  std::set<std::string> others{};  ///< files that the first one names

  /// Whether the child at that step can do without it.
  bool add(const std::string& step) {
    if (step.starts_with(kReadingNames)) return !std::exchange(names, true);
    if (step.starts_with(kMakingDamaged)) return !std::exchange(damaged, true);
    return step.starts_with(kReadingParts) &&
           others.insert(step.substr(kReadingParts.size())).second;
  }
};

void allow_more_processor_time(rlim_t seconds) {
  rlimit bounds{};
  if (getrlimit(RLIMIT_CPU, &bounds) != 0 || bounds.rlim_cur == RLIM_INFINITY) return;
  bounds.rlim_cur = std::min(bounds.rlim_max, bounds.rlim_cur + seconds);
  setrlimit(RLIMIT_CPU, &bounds);
}

/// Options without what is to be avoided.
///
/// step   told each step of the file and, of those that it names, which is read; not if empty
ReadOptions without(const Avoided& avoided, ReadOptions options, const Step& step) {
  options.names = options.names && !avoided.names;
  options.damaged = options.damaged && !avoided.damaged;
  options.other = [=, other = options.other](const std::filesystem::path& file) {
    ReadOptions its = other ? other(file) : options;
    its.left_out = avoided.others.contains(file.string());
    if (!step) return its;
    allow_more_processor_time(whole_seconds(reading_allowance(file)));
    its.step = [=](const char*) { step((std::string(kReadingParts) + file.string()).c_str()); };
    return its;
  };
  if (step) options.step = step;
  return options;
}

}  // namespace

Model read_model_in_child(const std::filesystem::path& file, const ReadOptions& options,
                          const std::function<void()>& stop) {
  const rlim_t seconds = whole_seconds(reading_allowance(file));
  ReadOptions wanted = options;
  wanted.step = [&stop](const char*) {
    if (stop) stop();
  };
  Avoided avoided;
  while (true) {
    std::optional<Model> model;
    const auto read = [&](const Step& step) {
      const Step told = [&](const char* doing) {
        step(doing);
        if (options.step) options.step(doing);
      };
      model = read_model(file, without(avoided, wanted, told));
    };
    const Rehearsal done =
        rehearse({read, [&model] { return ModelBytes::of(*model); }}, seconds, stop);
    if (done.handed_over)
      if (auto taken = taken_over([&] { return ModelBytes::model(*done.handed_over, file); }))
        return *std::move(taken);
    if (done.handed_over || done.finished) {
      make_sure_of(done.memory);
      return read_model(file, without(avoided, wanted, {}));
    }
    if (!avoided.add(done.step)) refuse_unfinished(file.string(), done, seconds);
  }
}

TopoDS_Shape rehearsed_shape_from_bytes(std::string_view bytes, const std::string& name,
                                        const std::function<void()>& stop) {
  const rlim_t seconds = whole_seconds(reading_allowance(static_cast<double>(bytes.size())));
  TopoDS_Shape shape;
  const auto read = [&](const Step& step) {
    step("reading the shapes");
    shape = shape_from_bytes(bytes, name);
  };
  const Rehearsal done = rehearse({read, [&shape] { return exact_bytes(shape); }}, seconds, stop);
  if (done.handed_over)
    if (auto taken = taken_over([&] { return shape_of_exact_bytes(*done.handed_over); }))
      return *std::move(taken);
  if (!done.handed_over && !done.finished) refuse_unfinished(name, done, seconds);
  make_sure_of(done.memory);
  return shape_from_bytes(bytes, name);
}

}  // namespace blossom::occt
