// SPDX-License-Identifier: LGPL-2.1-or-later
// One command line, from its words to its exit code.

#pragma once

namespace blossom::cli {

/// Chooses the command, lets it work in this process, and turns errors into messages on stderr.
/// returns  the exit code
int run_program(int argc, char** argv);

}  // namespace blossom::cli
