// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/base/shared_limit.h"

#include <algorithm>
#include <string>

namespace blossom::occt {

IntersectionOptions SharedLimit::remaining() const {
  constexpr double kMinSeconds = 1e-3;
  IntersectionOptions left = options_;
  left.threads = 0;
  if (options_.time_limit > 0)
    left.time_limit = std::max(kMinSeconds, options_.time_limit - seconds());
  if (options_.cancelled)
    left.cancelled = [this] {
      const std::lock_guard lock(asking_);
      return options_.cancelled();
    };
  return left;
}

IntersectionOptions SharedLimit::remaining_alone() const {
  IntersectionOptions left = remaining();
  left.threads = options_.threads;
  return left;
}

bool SharedLimit::is_reached() const {
  if (options_.time_limit > 0 && seconds() >= options_.time_limit) return true;
  const std::lock_guard lock(asking_);
  return options_.cancelled && options_.cancelled();
}

double SharedLimit::seconds() const {
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - started_;
  return spent.count();
}

void check_limit(const WorkLimit* limit, const char* work) {
  const char* reason = limit == nullptr ? nullptr : limit->reached_after_search();
  if (reason != nullptr) throw LimitFailure(std::string(work) + ": " + reason);
}

}  // namespace blossom::occt
