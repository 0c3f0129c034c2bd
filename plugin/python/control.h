// SPDX-License-Identifier: LGPL-2.1-or-later
// Long work without Python's lock, that Ctrl-C, a handle or a time limit ends.
//
// Python notices signals only in its main thread and only when asked. So the work runs in a thread
// of its own, and the calling thread asks now and then.

#pragma once

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <stdexcept>

#include <pybind11/pybind11.h>

#include "adapters/occt/distance.h"
#include "core/results/options.h"
#include "plugin/python/workers.h"

namespace blossom::python {

/// What another thread ends work by. Shared by Python's object and the work.
struct Cancel {
  std::atomic<bool> asked{false};
};

/// The work was ended by its Cancel.
class CancelledWork : public std::runtime_error {
 public:
  CancelledWork() : std::runtime_error("the work was cancelled") {}
};

/// What a caller says of the way a question is answered; each has what it needs of it.
struct Control {
  IntersectionOptions engine{};
  int nice = 0;  ///< how far the work gives way to the caller, see workers.h
  std::shared_ptr<Cancel> cancel{};
  pybind11::object progress = pybind11::none();  ///< called with the seconds since the start
};

/// What the work asks. It is used by the work's thread alone and those that it starts.
class Watch {
 public:
  /// Without limits.
  Watch() = default;
  explicit Watch(const Control& control) : engine_(control.engine), cancel_(control.cancel) {}

  bool ended() const { return interrupted_ || (cancel_ && cancel_->asked); }
  void interrupt() { interrupted_ = true; }
  /// Ends the work.
  /// throws   CancelledWork
  void stop() const {
    if (ended()) throw CancelledWork();
  }
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  /// What is left of the time limit; 0 if there is none.
  double seconds_left() const;
  /// The caller's options, with the time that is left.
  IntersectionOptions engine() const;
  /// Likewise for distances.
  DistanceOptions distance() const;

 private:
  const IntersectionOptions engine_{};
  const std::shared_ptr<Cancel> cancel_;
  std::atomic<bool> interrupted_{false};
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Runs `work(watch)` with the lock released. On a signal, or an exception of the caller's
/// `progress`, the work is ended, its answer awaited and dropped, and that exception goes on.
/// throws   CancelledWork if the caller's Cancel ended it, and what the work throws
template <class Work>
auto interruptible(const Control& control, Work&& work) {
  constexpr std::chrono::milliseconds kPause{20};
  Watch watch(control);
  auto answer = start_in_worker([&] { return work(watch); }, control.nice);
  bool interrupted = false;
  {
    const pybind11::gil_scoped_release released;
    while (!interrupted && answer.wait_for(kPause) != std::future_status::ready) {
      const pybind11::gil_scoped_acquire locked;
      interrupted = PyErr_CheckSignals() != 0;
      if (interrupted || control.progress.is_none()) continue;
      PyObject* const told = PyObject_CallFunction(control.progress.ptr(), "d", watch.seconds());
      interrupted = told == nullptr;
      Py_XDECREF(told);
    }
    if (interrupted) watch.interrupt();
    answer.wait();
  }
  if (interrupted) throw pybind11::error_already_set();
  watch.stop();
  return answer.get();
}

}  // namespace blossom::python
