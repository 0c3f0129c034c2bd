// SPDX-License-Identifier: LGPL-2.1-or-later
// What the help of a command ends with.

#pragma once

#include <CLI/App.hpp>

namespace blossom::cli {

/// Gives each command below its examples and what its exit codes mean.
void add_examples(CLI::App& app);

}  // namespace blossom::cli
