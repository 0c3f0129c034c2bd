// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/interruption.h"

#include <unistd.h>

#include <csignal>

#include "plugin/cli/exit_code.h"

namespace blossom::cli {
namespace {

// Programs that start others may send the signal twice for one wish to stop.
constexpr int kPatience = 2;

volatile std::sig_atomic_t times_asked = 0;

extern "C" void remember_signal(int) {
  times_asked = times_asked + 1;
  if (times_asked > kPatience) _exit(kExitInterrupted);
}

}  // namespace

void watch_for_interruption() {
  std::signal(SIGINT, remember_signal);
  std::signal(SIGTERM, remember_signal);
}

bool interrupted() { return times_asked > 0; }

void stop_if_interrupted() {
  if (interrupted()) throw Interrupted();
}

}  // namespace blossom::cli
