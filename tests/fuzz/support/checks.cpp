// SPDX-License-Identifier: LGPL-2.1-or-later
#include <sys/time.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "tests/fuzz/support/target.h"

namespace blossom::fuzz {
namespace {

void end_late(int) {
  constexpr std::string_view kWords = "fuzzing: the input takes more processor time than it may\n";
  if (write(STDERR_FILENO, kWords.data(), kWords.size()) < 0) _exit(1);
  std::abort();
}

}  // namespace

void watch_time() {
  std::signal(SIGPROF, end_late);
  const itimerval limit{{0, 0}, {kMaxSeconds, 0}};
  setitimer(ITIMER_PROF, &limit, nullptr);
}

void stop_watching_time() {
  const itimerval none{};
  setitimer(ITIMER_PROF, &none, nullptr);
}

void require(bool holds, const char* words) {
  if (holds) return;
  std::fprintf(stderr, "fuzzing: %s\n", words);
  std::abort();
}

}  // namespace blossom::fuzz
