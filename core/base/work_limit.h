// SPDX-License-Identifier: LGPL-2.1-or-later
// When the user wants a search to end: by time, by asking for it, or by a budget of steps.

#pragma once

#include <chrono>
#include <functional>
#include <string_view>

namespace blossom {

class WorkLimit {
 public:
  static constexpr const char* kCancelled = "cancelled";

  /// The time limit begins to run.
  ///
  /// seconds     0: no limit
  /// cancelled   kept by reference
  WorkLimit(double seconds, const std::function<bool()>& cancelled)
      : seconds_(seconds), cancelled_(cancelled) {}
  WorkLimit(double seconds, std::function<bool()>&& cancelled) = delete;

  /// Of anything that has a `time_limit` in seconds and a function `cancelled`; kept by reference.
  template <class Options>
  explicit WorkLimit(const Options& options) : WorkLimit(options.time_limit, options.cancelled) {}
  template <class Options>
  explicit WorkLimit(const Options&& options) = delete;

  /// Why the work has to end now; null if it may go on.
  const char* reached() const {
    if (cancelled_ && cancelled_()) return kCancelled;
    return spent() > 1 ? kLate : nullptr;
  }

  /// The same for what follows a search: its results want some time of their own.
  const char* reached_after_search() const {
    if (cancelled_ && cancelled_()) return kCancelled;
    return late_after_search() ? kLate : nullptr;
  }

  /// Whether a reason that a limit gave is the user's wish.
  static bool is_cancelled(std::string_view reason) { return reason == kCancelled; }

  /// By time alone, so any thread may ask.
  bool late_after_search() const { return spent() > 1 + kAfterSearch; }

 private:
  static constexpr const char* kLate = "the time limit is reached";
  static constexpr double kAfterSearch = 0.25;

  // As a part of the limit.
  double spent() const {
    if (!(seconds_ > 0)) return 0;
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - started_;
    return time.count() / seconds_;
  }

  const double seconds_;
  const std::function<bool()>& cancelled_;
  const std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
};

/// Asks a limit once in a while about work that follows a search; when it is reached it stays so.
/// For one thread.
class PolledLimit {
 public:
  explicit PolledLimit(const WorkLimit& limit) : limit_(limit) {}

  bool reached() {
    if (reason_ == nullptr && asked_++ % kAskEvery == 0) reason_ = limit_.reached_after_search();
    return reason_ != nullptr;
  }

  /// Null if it was not reached.
  const char* reason() const { return reason_; }

 private:
  static constexpr long kAskEvery = 16;

  const WorkLimit& limit_;
  long asked_ = 0;
  const char* reason_ = nullptr;
};

/// What all parts of one search may spend together: the budget and the time of its options. For one
/// thread.
class SharedWork {
 public:
  /// Steps between two looks at the clock, which takes as long as one of them. A choice: a step
  /// takes some microseconds, so a search is late by a millisecond at most.
  static constexpr long kAskEvery = 256;

  /// Of anything that WorkLimit takes and that has a `budget` of steps; kept by reference. The time
  /// limit begins to run.
  template <class Options>
  explicit SharedWork(const Options& options) : limit_(options), budget_(options.budget) {}
  template <class Options>
  explicit SharedWork(const Options&& options) = delete;

  /// Counts a step. Why the work has to end now, and stays ended; null if it may go on.
  const char* step() {
    if (reason_) return reason_;
    if (++steps_ % kAskEvery == 0) reason_ = limit_.reached();
    if (steps_ > budget_) reason_ = "the budget is spent";
    return reason_;
  }

  /// Why it ended; null if it did not.
  const char* reason() const { return reason_; }

 private:
  WorkLimit limit_;
  long budget_, steps_ = 0;
  const char* reason_ = nullptr;
};

}  // namespace blossom
