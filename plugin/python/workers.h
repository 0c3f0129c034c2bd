// SPDX-License-Identifier: LGPL-2.1-or-later
// Threads that wait for the next question: to make one takes as long as a small question.

#pragma once

#include <functional>
#include <future>
#include <memory>
#include <utility>

namespace blossom::python {

/// Runs `task` in a thread that waits, or in a new one. Threads have the priority of the one that
/// made them, so they serve only callers of that priority. After a fork the child makes its own.
void run_in_worker(std::function<void()> task);

/// The answer of `work`, which runs in such a thread, or what it throws.
template <class Work>
auto start_in_worker(Work work) -> std::future<decltype(work())> {
  const auto task = std::make_shared<std::packaged_task<decltype(work())()>>(std::move(work));
  auto answer = task->get_future();
  run_in_worker([task] { (*task)(); });
  return answer;
}

}  // namespace blossom::python
