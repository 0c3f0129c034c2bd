// SPDX-License-Identifier: LGPL-2.1-or-later
// When the user wants a search to end: by time or by asking for it.

#pragma once

#include <chrono>

#include "core/intersection/options.h"

namespace blossom {

class WorkLimit {
 public:
  /// The time limit begins to run.
  explicit WorkLimit(const IntersectionOptions& options) : options_(options) {}

  /// Why the work has to end now; null if it may go on.
  const char* reached() const {
    if (options_.cancelled && options_.cancelled()) return "cancelled";
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - started_;
    const bool late = options_.time_limit > 0 && spent.count() > options_.time_limit;
    return late ? "the time limit is reached" : nullptr;
  }

 private:
  const IntersectionOptions& options_;
  const std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
};

}  // namespace blossom
