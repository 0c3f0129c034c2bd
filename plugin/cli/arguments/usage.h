// SPDX-License-Identifier: LGPL-2.1-or-later
// What is wrong with a command line, in words.

#pragma once

#include <string>
#include <vector>

#include <CLI/App.hpp>

namespace blossom::cli {

/// What the parser found wrong: "intersect needs two models; the second is missing", "check has no
/// option '--jsno'; did you mean '--json'?".
/// app   that refused to parse
std::string usage_message(const CLI::App& app, const CLI::ParseError& error);

/// "see 'blossom intersect --help'", of the command that was being parsed.
std::string help_line(const CLI::App& app);

/// The help text of a command, `words` being its name: {"query", "ray"}; none for the program's.
/// throws   UsageError if there is no such command
std::string help_text(const CLI::App& app, const std::vector<std::string>& words);

}  // namespace blossom::cli
