// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/python/workers.h"

#include <algorithm>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include <oneapi/tbb/task_scheduler_observer.h>

#if defined(__unix__)
#include <pthread.h>
#include <sys/resource.h>
#endif

#include "adapters/occt/base/errors.h"
#include "core/base/parallel.h"

namespace blossom::python {
namespace {

struct Worker {
  int priority = 0;
  std::mutex lock{};
  std::condition_variable wake{};
  std::function<void()> task{};  // empty while it waits
};

// Never destroyed: threads wait in it until the process ends.
struct Pool {
  std::mutex lock{};
  std::map<int, std::vector<Worker*>> idle{};  // by priority
};

Pool& pool() {
  static Pool* const the_pool = new Pool;
  return *the_pool;
}

constexpr int kLastPriority = 19;  // of Linux; larger ones come later

// Of the calling thread.
int current_priority() {
#if defined(__linux__)
  return ::getpriority(PRIO_PROCESS, 0);
#else
  return 0;
#endif
}

// For the calling thread, if it has a higher one, and those that it makes. A system that has no
// such thing runs as it does.
void give_way([[maybe_unused]] int priority) {
#if defined(__linux__)
  if (priority > current_priority()) ::setpriority(PRIO_PROCESS, 0, priority);
#endif
}

// Threads that help the one that made it give way as it does. They may be older: Open CASCADE has
// them from the same pool, to show shapes. (They stay like that, as all that have given way.)
class Helpers : public oneapi::tbb::task_scheduler_observer {
 public:
  explicit Helpers(int priority) : priority_(priority) { observe(true); }
  ~Helpers() override { observe(false); }
  void on_scheduler_entry(bool) override { give_way(priority_); }

 private:
  const int priority_;
};

// Only the thread that forks goes on in the child.
void forget_workers_in_children() {
#if defined(__unix__)
  ::pthread_atfork([] { pool().lock.lock(); }, [] { pool().lock.unlock(); },
                   [] {
                     pool().idle.clear();
                     pool().lock.unlock();
                   });
#endif
}

void serve(Worker* worker) {
  give_way(worker->priority);
  std::optional<Helpers> helpers;
  if (threads_can_help()) helpers.emplace(worker->priority);
  while (true) {
    std::function<void()> task;
    {
      std::unique_lock guard(worker->lock);
      worker->wake.wait(guard, [worker] { return static_cast<bool>(worker->task); });
      task = std::exchange(worker->task, {});
    }
    task();
    task = {};  // what it holds goes before the next one comes
    const std::lock_guard guard(pool().lock);
    pool().idle[worker->priority].push_back(worker);
  }
}

void start(Worker* worker) {
  try {
    std::thread(serve, worker).detach();
  } catch (const std::system_error& refused) {
    throw occt::Failure(std::string("the system has no thread for the work: ") + refused.what());
  }
}

Worker* waiting_worker(int priority) {
  const std::lock_guard guard(pool().lock);
  std::vector<Worker*>& idle = pool().idle[priority];
  if (idle.empty()) return nullptr;
  Worker* const worker = idle.back();
  idle.pop_back();
  return worker;
}

}  // namespace

void run_in_worker(std::function<void()> task, int nice) {
  static std::once_flag once;
  std::call_once(once, forget_workers_in_children);
  const int priority = std::min(current_priority() + nice, kLastPriority);
  Worker* worker = waiting_worker(priority);
  if (worker == nullptr) {
    auto made = std::make_unique<Worker>();
    made->priority = priority;
    made->task = std::move(task);
    start(made.get());
    made.release();  // its thread's from now on
    return;
  }
  {
    const std::lock_guard guard(worker->lock);
    worker->task = std::move(task);
  }
  worker->wake.notify_one();
}

}  // namespace blossom::python
