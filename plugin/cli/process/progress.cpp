// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/process/progress.h"

#include <unistd.h>

#include <cstdio>
#include <utility>

#include "plugin/cli/output/verbosity.h"
#include "plugin/cli/process/supervision.h"

namespace blossom::cli {

Progress::Progress(std::string doing)
    : doing_(std::move(doing)),
      silent_(verbosity() == Verbosity::Quiet || isatty(STDERR_FILENO) == 0) {
  enter(Phase::Working, doing_);
}

Progress::~Progress() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void Progress::tick() {
  if (silent_) return;
  const Clock::time_point now = Clock::now();
  if (now < next_) return;
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(now - start_).count();
  std::fprintf(stderr, "\r\033[K%s ... %lld s", doing_.c_str(), static_cast<long long>(seconds));
  std::fflush(stderr);
  shown_ = true;
  next_ = now + std::chrono::milliseconds(500);
}

}  // namespace blossom::cli
