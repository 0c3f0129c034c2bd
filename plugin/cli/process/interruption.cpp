// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/process/interruption.h"

#include <csignal>

#include "plugin/cli/exit_code.h"

namespace blossom::cli {
namespace {

volatile std::sig_atomic_t stop_asked = 0;

extern "C" void remember_signal(int) { stop_asked = 1; }

}  // namespace

void watch_for_interruption() {
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, remember_signal);
  // Under nohup the end of the terminal is nobody's wish.
  if (std::signal(SIGHUP, remember_signal) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
}

bool interrupted() { return stop_asked != 0; }

void stop_if_interrupted() {
  if (interrupted()) throw Interrupted();
}

}  // namespace blossom::cli
