// SPDX-License-Identifier: LGPL-2.1-or-later
// Work shared by the processor's cores. What a task computes must not depend on other tasks of the
// same call: then results are the same for any number of threads.

#pragma once

#include <cstddef>
#include <functional>

namespace blossom {

/// False in a child that was forked after the first call of this or of what follows: there the
/// threads are lost, and so are the locks of oneTBB that they held at that moment, which is not to
/// be asked any more. All work is done by the calling thread then.
bool threads_can_help();

/// Starts the threads ahead of the first call, unless only one is wanted. It takes about as long as
/// the intersection of two small patches.
void start_threads(int threads);

/// Runs `work` with at most so many threads for its parallel parts; 0 is as many as there are
/// cores, 1 is none but the caller's.
void with_threads(int threads, const std::function<void()>& work);

/// Calls task(0) .. task(count - 1), in any order and at the same time, and returns when all are
/// done. An exception of a task is passed on.
///
/// grain     tasks that one thread does in a row; as many as take some 20 microseconds
void parallel_for(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t)>& task);

}  // namespace blossom
