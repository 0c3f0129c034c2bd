// SPDX-License-Identifier: LGPL-2.1-or-later
// Long work without Python's lock, that Ctrl-C ends.
//
// Python notices signals only in its main thread and only when asked. So the work runs in a
// thread of its own, and the calling thread asks now and then.

#pragma once

#include <atomic>
#include <chrono>
#include <future>

#include <pybind11/pybind11.h>

namespace blossom::python {

/// Runs `work(cancelled)`; the lock is released meanwhile. On a signal `cancelled` turns true,
/// the work's answer is awaited and dropped, and Python's exception goes on.
template <class Work>
auto interruptible(Work&& work) {
  constexpr std::chrono::milliseconds kPause{20};
  std::atomic<bool> cancelled{false};
  auto answer = std::async(std::launch::async, [&] { return work(cancelled); });
  bool interrupted = false;
  {
    const pybind11::gil_scoped_release released;
    while (answer.wait_for(kPause) != std::future_status::ready) {
      const pybind11::gil_scoped_acquire locked;
      interrupted = PyErr_CheckSignals() != 0;
      if (interrupted) break;
    }
    cancelled = interrupted;
    answer.wait();
  }
  if (interrupted) throw pybind11::error_already_set();
  return answer.get();
}

}  // namespace blossom::python
