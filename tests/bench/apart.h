// SPDX-License-Identifier: LGPL-2.1-or-later
// Work that may not end or may take the program down, in a process of its own.

#pragma once

#include <cstddef>
#include <functional>
#include <type_traits>

namespace blossom::bench {

enum class Ending { Done, OutOfTime, Died };

/// Processor time of this process so far, seconds. In a process with a limit the kernel counts it
/// in ticks of some milliseconds.
double processor_seconds();

/// Processor time of this thread alone, to the nanosecond.
double thread_seconds();

/// Does work in a process of its own, no longer than `limit` seconds of processor time. What it
/// leaves in `answer` comes back if it gets done.
Ending work_apart(double limit, const std::function<void()>& work, void* answer, std::size_t size);

/// The same for work that returns plain values.
template <class Answer>
Ending apart(double limit, Answer& answer, const std::function<Answer()>& work) {
  static_assert(std::is_trivially_copyable_v<Answer>);
  return work_apart(
      limit, [&] { answer = work(); }, &answer, sizeof answer);
}

}  // namespace blossom::bench
