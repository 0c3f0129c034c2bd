// SPDX-License-Identifier: LGPL-2.1-or-later
// What man pages and completion ask about commands.

#pragma once

#include <string>
#include <vector>

#include <CLI/App.hpp>

namespace blossom::cli {

/// The command itself, then those below it, depth first.
std::vector<const CLI::App*> with_subcommands(const CLI::App& command);

/// The words that call a command, from the program's name on.
/// between   what stands between two words
std::string called(const CLI::App& command, const std::string& between);

std::vector<const CLI::App*> subcommands(const CLI::App& command);

/// Options with a dash, and arguments without, in the order they were added.
std::vector<const CLI::Option*> options(const CLI::App& command);
std::vector<const CLI::Option*> arguments(const CLI::App& command);

/// "-o" and "--output", with their dashes.
std::vector<std::string> names(const CLI::Option& option);

}  // namespace blossom::cli
