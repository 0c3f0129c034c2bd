// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/batch/progress_line.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <sstream>

#include "plugin/cli/output/verbosity.h"

namespace blossom::cli {
namespace {

constexpr std::chrono::milliseconds kEvery(500);

// As people say it: "40 s", "12 min", "3 h 5 min".
std::string duration_text(double seconds) {
  constexpr double kMinute = 60, kHour = 3600, kSecondsUpTo = 120;
  const auto whole = [](double value) { return std::to_string(std::lround(value)); };
  if (seconds < kSecondsUpTo) return whole(seconds) + " s";
  if (seconds < kHour) return whole(seconds / kMinute) + " min";
  const double hours = std::floor(seconds / kHour);
  return whole(hours) + " h " + whole(std::floor((seconds - hours * kHour) / kMinute)) + " min";
}

}  // namespace

std::string progress_text(std::size_t done, std::size_t all, std::size_t failed, std::size_t now,
                          double seconds) {
  std::ostringstream text;
  text << done << " of " << counted(all, "job");
  if (failed > 0) text << ", " << failed << " failed";
  if (now == 0 || !(seconds > 0)) return text.str();
  const double rate = static_cast<double>(now) / seconds;
  text.precision(3);
  text << "; " << rate << " a second, " << duration_text(static_cast<double>(all - done) / rate)
       << " left";
  return text.str();
}

ProgressLine::ProgressLine(std::size_t open, const Tally& tally)
    : tally_(tally),
      before_(tally.count()),
      all_(before_ + open),
      silent_(verbosity() == Verbosity::Quiet || isatty(STDERR_FILENO) == 0) {}

ProgressLine::~ProgressLine() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void ProgressLine::tick() {
  const Clock::time_point time = Clock::now();
  if (silent_ || time < next_) return;
  const double seconds = std::chrono::duration<double>(time - start_).count();
  const std::string text = progress_text(tally_.count(), all_, tally_.count(JobStatus::Failed),
                                         tally_.count() - before_, seconds);
  std::fprintf(stderr, "\r\033[K%s", text.c_str());
  std::fflush(stderr);
  shown_ = true;
  next_ = time + kEvery;
}

}  // namespace blossom::cli
