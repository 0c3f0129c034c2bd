// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom blend fill`: patches in the holes of a model.

#pragma once

#include <CLI/App.hpp>

namespace blossom::cli {

void add_blend_fill(CLI::App& blend, int& exit_code);

}  // namespace blossom::cli
