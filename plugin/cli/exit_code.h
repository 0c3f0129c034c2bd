// SPDX-License-Identifier: LGPL-2.1-or-later
// What the command line answers to the shell, and the errors that lead there.

#pragma once

#include <stdexcept>

#include "core/base/status.h"

namespace blossom::cli {

inline constexpr int kExitComplete = 0;
inline constexpr int kExitFailure = 1;    ///< no output: unwritable, empty, internal error
inline constexpr int kExitBadInput = 2;   ///< bad usage or bad input
inline constexpr int kExitTolerance = 3;  ///< right but for what is listed
inline constexpr int kExitStopped = 4;    ///< by a limit
inline constexpr int kExitFindings = 5;   ///< of commands that look for something, with --fail-on
inline constexpr int kExitInterrupted = 130;

/// The exit code of a finished command.
int exit_code(Status status);

/// The same of a command that ends with `code` where a file that was asked for is not written:
/// never that of a success, so that nothing goes on with a file that is not there, or with an older
/// one.
int exit_code_unwritten(int code);

/// The command was used wrongly: an option's value that makes no sense, an input that cannot be
/// meant. Exit code 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The user pressed Ctrl-C; nothing was written. Exit code 130.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted, nothing was written") {}
};

}  // namespace blossom::cli
