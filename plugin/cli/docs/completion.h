// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include <CLI/App.hpp>

namespace blossom::cli {

/// A script for bash that completes commands, options and the words an option can take; files
/// where anything else is wanted.
std::string bash_completion(const CLI::App& program);

}  // namespace blossom::cli
