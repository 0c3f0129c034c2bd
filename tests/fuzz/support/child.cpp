// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/fuzz/support/child.h"

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <new>

#include "tests/fuzz/support/target.h"

// The counters of clang's coverage, if this program has any.
extern "C" {
[[gnu::weak]] extern char __start___sancov_cntrs[];
[[gnu::weak]] extern char __stop___sancov_cntrs[];
}

namespace blossom::fuzz {
namespace {

constexpr int kFinding = 77;  // exit code of sanitizers, see __asan_default_options

class SharedParts : public Parts {
 public:
  void reading() override { in_reading = true; }
  void ours() override { in_reading = false; }

  std::atomic<bool> in_reading{false};
};

// Puts the whole pages of the counters into memory that children share.
void share_counters() {
  static bool is_done = false;
  if (is_done || __start___sancov_cntrs == nullptr) return;
  is_done = true;
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  const std::uintptr_t first =
      (reinterpret_cast<std::uintptr_t>(__start___sancov_cntrs) + page - 1) / page * page;
  const std::uintptr_t last = reinterpret_cast<std::uintptr_t>(__stop___sancov_cntrs) / page * page;
  if (last <= first) return;
  void* const shared = mmap(reinterpret_cast<void*>(first), last - first, PROT_READ | PROT_WRITE,
                            MAP_SHARED | MAP_ANONYMOUS | MAP_FIXED, -1, 0);
  require(shared != MAP_FAILED, "there is no memory for counters");
}

SharedParts& shared_parts() {
  static SharedParts* const parts = [] {
    void* const memory = mmap(nullptr, sizeof(SharedParts), PROT_READ | PROT_WRITE,
                              MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    require(memory != MAP_FAILED, "there is no memory to share");
    return new (memory) SharedParts;
  }();
  return *parts;
}

[[noreturn]] void work_as_child(const std::function<void(Parts&)>& work, SharedParts& parts) {
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) std::signal(signal, SIG_DFL);
  watch_time();
  work(parts);
  _exit(0);
}

}  // namespace

void in_child(const std::function<void(Parts&)>& work) {
  share_counters();
  SharedParts& parts = shared_parts();
  parts.ours();
  const pid_t child = fork();
  require(child >= 0, "no process can be made");
  if (child == 0) work_as_child(work, parts);
  int status = 0;
  while (waitpid(child, &status, 0) < 0) require(errno == EINTR, "a child is lost");
  if (WIFSIGNALED(status) && !parts.in_reading)
    require(false, WTERMSIG(status) == SIGABRT ? "a check failed, or it takes too long"
                                               : strsignal(WTERMSIG(status)));
  require(!WIFEXITED(status) || WEXITSTATUS(status) != kFinding, "a sanitizer found something");
  require(WIFSIGNALED(status) || WEXITSTATUS(status) == 0, "an unknown exit code");
}

}  // namespace blossom::fuzz

// Signals stay signals, and what the sanitizers find is an exit code of its own.
extern "C" const char* __asan_default_options() {
  return "exitcode=77:handle_segv=0:handle_sigbus=0:handle_sigfpe=0:handle_sigill=0:handle_abort=0:"
         "allocator_may_return_null=1";
}
