// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/base/parallel.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

namespace blossom {

void start_threads(int threads) {
  if (threads != 1) parallel_for(64, 1, [](std::size_t) {});
}

void with_threads(int threads, const std::function<void()>& work) {
  if (threads <= 0) return work();
  oneapi::tbb::task_arena arena(threads);
  arena.execute(work);
}

void parallel_for(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t)>& task) {
  if (count <= grain) {
    for (std::size_t i = 0; i < count; ++i) task(i);
    return;
  }
  // Isolated, so that a thread that waits here does not begin with another call's work.
  oneapi::tbb::this_task_arena::isolate([&] {
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<std::size_t>(0, count, grain),
                              [&](const auto& range) {
                                for (std::size_t i = range.begin(); i < range.end(); ++i) task(i);
                              });
  });
}

}  // namespace blossom
