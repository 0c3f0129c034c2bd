// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include <CLI/App.hpp>

namespace blossom::cli {

/// The manual page of a command in roff, as `man` reads it; made from its options alone.
std::string man_page(const CLI::App& command);

}  // namespace blossom::cli
