// SPDX-License-Identifier: LGPL-2.1-or-later
// The commands of Blossom in DRAW. Each function adds one command to the interpreter.

#pragma once

#include <Draw_Interpretor.hxx>

namespace blossom::draw {

inline constexpr const char* kGroup = "Blossom commands";

void add_blinfo(Draw_Interpretor& interpreter);
void add_blintersect(Draw_Interpretor& interpreter);
void add_bltrim(Draw_Interpretor& interpreter);
void add_blsolid(Draw_Interpretor& interpreter);
void add_blsection(Draw_Interpretor& interpreter);
void add_bldistance(Draw_Interpretor& interpreter);
void add_blclash(Draw_Interpretor& interpreter);
void add_blcheck(Draw_Interpretor& interpreter);
void add_blsubdivide(Draw_Interpretor& interpreter);
void add_blfillet(Draw_Interpretor& interpreter);
void add_blchamfer(Draw_Interpretor& interpreter);
void add_blblend(Draw_Interpretor& interpreter);
void add_blfill(Draw_Interpretor& interpreter);

}  // namespace blossom::draw
