// SPDX-License-Identifier: LGPL-2.1-or-later
// Threads that wait for the next question: to make one takes as long as a small question.

#pragma once

#include <functional>
#include <future>
#include <memory>
#include <utility>

namespace blossom::python {

/// Runs `task` in a thread that waits, or in a new one. A thread that has given way can not take
/// its priority back, so each serves only callers of one priority. After a fork the child makes its
/// own.
///
/// nice   how far it gives way to the calling thread, which keeps its priority: 0 not at all, at
///        most 19. Only on Linux threads have priorities of their own.
void run_in_worker(std::function<void()> task, int nice);

/// The answer of `work`, which runs in such a thread, or what it throws.
template <class Work>
auto start_in_worker(Work work, int nice) -> std::future<decltype(work())> {
  const auto task = std::make_shared<std::packaged_task<decltype(work())()>>(std::move(work));
  auto answer = task->get_future();
  run_in_worker([task] { (*task)(); }, nice);
  return answer;
}

}  // namespace blossom::python
