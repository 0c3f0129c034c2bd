// SPDX-License-Identifier: LGPL-2.1-or-later
// The kinds of `blossom blend`, one file each.

#pragma once

#include <CLI/App.hpp>

namespace blossom::cli {

void add_blend_fillet(CLI::App& blend, int& exit_code);
void add_blend_chamfer(CLI::App& blend, int& exit_code);

}  // namespace blossom::cli
