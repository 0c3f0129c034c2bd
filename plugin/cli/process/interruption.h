// SPDX-License-Identifier: LGPL-2.1-or-later
// Ctrl-C asks the work to stop; whoever supervises it waits for that only so long.

#pragma once

namespace blossom::cli {

/// Takes over SIGINT, SIGTERM and SIGHUP. Call it once, first.
void watch_for_interruption();

bool interrupted();

/// throws   Interrupted if the user has asked to stop; call it before anything is written
void stop_if_interrupted();

}  // namespace blossom::cli
