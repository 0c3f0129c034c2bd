// SPDX-License-Identifier: LGPL-2.1-or-later
// --reproduce DIR: what repeats a command that failed or was stopped, as small as it can be found.

#pragma once

#include <functional>
#include <string>
#include <vector>

#include "plugin/cli/process/reduction.h"

namespace blossom::cli {

/// Runs a command line under supervision. If its exit code is 1 or 4, or it crashed, and it has
/// --reproduce DIR, the folder gets its inputs and repeat, which repeats it there. A batch leaves
/// that to its jobs.
///
/// Of inputs that are models only those solids and faces stay that it takes: runs of them are left
/// out, shorter and shorter ones, as long as the command comes to the same end and says the same
/// then, but for names and numbers. Each face that is left is one that cannot be left out alone,
/// unless time is over: 20 times as long as the command itself, and a minute at least.
///
/// words     the program's name first
/// ended     told before that begins
/// returns   how the command itself came out
Ended run_reproducibly(const std::vector<std::string>& words, const Program& program,
                       const std::function<void(const Ended&)>& ended = {});

}  // namespace blossom::cli
