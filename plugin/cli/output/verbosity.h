// SPDX-License-Identifier: LGPL-2.1-or-later
// How much the program says beside its results: -q, nothing, -v.

#pragma once

#include <string>

namespace blossom::cli {

enum class Verbosity {
  Quiet,   ///< -q: errors, and what was asked for with --json -
  Normal,  ///< summaries and notes
  Verbose  ///< -v: details, too
};

/// What holds for the whole process; Normal until it is set.
Verbosity verbosity();
void set_verbosity(Verbosity level);

/// Prints "blossom: TEXT" on stderr, a line that every user should read; not with -q.
void note(const std::string& text);

/// The same for what explains a note or lists what it counts; only with -v.
void detail(const std::string& text);

}  // namespace blossom::cli
