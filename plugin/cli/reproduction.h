// SPDX-License-Identifier: LGPL-2.1-or-later
// --reproduce DIR: what repeats a command that failed or was stopped, as small as it can be found.

#pragma once

namespace blossom::cli {

/// Runs a command line under supervision. If its exit code is 1 or 4, or it crashed, and it has
/// --reproduce DIR, the folder gets its inputs and repeat, which repeats it there.
///
/// Of inputs that are models only those faces stay that it takes: halves of them are left out as
/// long as what is left comes to the same end, in up to 40 runs that take up to 20 times as long as
/// the command itself in all, and a minute at least.
///
/// returns  the exit code of the command
int run_reproducibly(int argc, char** argv);

}  // namespace blossom::cli
