// SPDX-License-Identifier: LGPL-2.1-or-later
// The commands of Blossom in DRAW. Each function adds one command to the interpreter.

#pragma once

#include <Draw_Interpretor.hxx>

namespace blossom::draw {

inline constexpr const char* kGroup = "Blossom commands";

void add_blintersect(Draw_Interpretor& interpreter);

}  // namespace blossom::draw
