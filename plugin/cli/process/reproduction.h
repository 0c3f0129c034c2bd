// SPDX-License-Identifier: LGPL-2.1-or-later
// --reproduce DIR: what repeats a command that failed or was stopped, as small as it can be found.

#pragma once

#include <functional>
#include <string>
#include <vector>

#include "plugin/cli/process/supervision.h"

namespace blossom::cli {

/// How a command came out.
struct Ended {
  int code = 0;
  Ending how;
};

/// What runs a command line in this process, as run_program does.
using Program = std::function<int(int argc, char** argv)>;

/// Runs a command line under supervision. If its exit code is 1 or 4, or it crashed, and it has
/// --reproduce DIR, the folder gets its inputs and repeat, which repeats it there. A batch leaves
/// that to its jobs.
///
/// Of inputs that are models only those faces stay that it takes: halves of them are left out as
/// long as what is left comes to the same end, in up to 40 runs that take up to 20 times as long as
/// the command itself in all, and a minute at least.
///
/// words     the program's name first
/// ended     told before that begins
/// returns   how the command itself came out
Ended run_reproducibly(const std::vector<std::string>& words, const Program& program,
                       const std::function<void(const Ended&)>& ended = {});

}  // namespace blossom::cli
