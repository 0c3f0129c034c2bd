// SPDX-License-Identifier: LGPL-2.1-or-later
// Ctrl-C: the first one asks the work to stop, the third one ends the program at once.

#pragma once

namespace blossom::cli {

/// Takes over SIGINT and SIGTERM. Call it once, first.
void watch_for_interruption();

bool interrupted();

/// throws   Interrupted if the user has asked to stop; call it before anything is written
void stop_if_interrupted();

}  // namespace blossom::cli
