// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/base/parallel.h"

#include <atomic>
#include <utility>

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#if defined(__unix__)
#include <pthread.h>
#endif

#if defined(BLOSSOM_TELL_THREAD_SANITIZER)
extern "C" {  // its interface
void __tsan_acquire(void* place);
void __tsan_release(void* place);
}
#endif

namespace blossom {
namespace {

// oneTBB is compiled without ThreadSanitizer, which has to be told that tasks begin after their
// call does and end before it goes on; of two tasks nothing is known.
class KnownOrder {
 public:
#if defined(BLOSSOM_TELL_THREAD_SANITIZER)
  void before_tasks() { __tsan_release(&first_); }
  void task_begins() { __tsan_acquire(&first_); }
  void task_ends() { __tsan_release(&last_); }
  void after_tasks() { __tsan_acquire(&last_); }

 private:
  char first_ = 0, last_ = 0;
#else
  void before_tasks() const {}
  void task_begins() const {}
  void task_ends() const {}
  void after_tasks() const {}
#endif
};

// True on a thread that is in an arena of its call's own and in no task: while it waits there, it
// may help with whatever is under way.
thread_local bool helps_with_all = false;

// Sets that mark, and puts back what was there.
class HelpMark {
 public:
  explicit HelpMark(bool helps) : before_(std::exchange(helps_with_all, helps)) {}
  ~HelpMark() { helps_with_all = before_; }
  HelpMark(const HelpMark&) = delete;
  HelpMark& operator=(const HelpMark&) = delete;

  bool before() const { return before_; }

 private:
  const bool before_;
};

std::atomic<bool> threads_are_lost{false};

bool notice_forks() {
#if defined(__unix__)
  ::pthread_atfork(nullptr, nullptr, [] { threads_are_lost = true; });
#endif
  return true;
}

}  // namespace

bool threads_can_help() {
  [[maybe_unused]] static const bool forks_are_noticed = notice_forks();
  return !threads_are_lost;
}

void start_threads(int threads) {
  if (threads != 1) parallel_for(64, 1, [](std::size_t) {});
}

void with_threads(int threads, const std::function<void()>& work) {
  if (threads <= 0 || !threads_can_help()) return work();
  oneapi::tbb::task_arena arena(threads);
  arena.execute([&] {
    const HelpMark mark(true);
    work();
  });
}

void parallel_for(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t)>& task) {
  if (count <= grain || !threads_can_help() ||
      oneapi::tbb::this_task_arena::max_concurrency() == 1) {
    for (std::size_t i = 0; i < count; ++i) task(i);
    return;
  }
  KnownOrder order;
  const auto run = [&] {
    order.before_tasks();
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<std::size_t>(0, count, grain),
                              [&](const auto& range) {
                                order.task_begins();
                                for (std::size_t i = range.begin(); i < range.end(); ++i) task(i);
                                order.task_ends();
                              });
    order.after_tasks();
  };
  // Isolated, so that a thread that waits here does not begin with another call's work; but not at
  // the outermost call, where that would keep it from calls in the last tasks of its own.
  const HelpMark mark(false);
  if (mark.before())
    run();
  else
    oneapi::tbb::this_task_arena::isolate(run);
}

}  // namespace blossom
