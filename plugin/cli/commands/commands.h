// SPDX-License-Identifier: LGPL-2.1-or-later
// The commands of the program `blossom`.
//
// Each function adds one subcommand with its options; when it is chosen, its callback does the
// work and stores the exit code. Errors leave as exceptions, main.cpp turns them into messages.

#pragma once

#include <CLI/App.hpp>

namespace blossom::cli {

/// What the program is, and all of its commands in the order of its help.
void add_commands(CLI::App& app, int& exit_code);

void add_info(CLI::App& app, int& exit_code);
void add_check(CLI::App& app, int& exit_code);
void add_intersect(CLI::App& app, int& exit_code);
void add_self_intersect(CLI::App& app, int& exit_code);
void add_trim(CLI::App& app, int& exit_code);
void add_blend(CLI::App& app, int& exit_code);
void add_subdivide(CLI::App& app, int& exit_code);
void add_convert(CLI::App& app, int& exit_code);
void add_clash(CLI::App& app, int& exit_code);
void add_query(CLI::App& app, int& exit_code);
void add_batch(CLI::App& app, int& exit_code);
void add_help(CLI::App& app, int& exit_code);

}  // namespace blossom::cli
