// SPDX-License-Identifier: LGPL-2.1-or-later
// The entry of the DRAW plugin: pload -BlossomPlugin BLOSSOM calls Factory once.

#include <Draw_PluginMacro.hxx>

#include "plugin/draw/commands/commands.h"

class BlossomDraw {
 public:
  static void Factory(Draw_Interpretor& interpreter) {
    static bool added = false;
    if (added) return;
    added = true;
    for (const auto add :
         {blossom::draw::add_blinfo, blossom::draw::add_blintersect, blossom::draw::add_bltrim,
          blossom::draw::add_blsolid, blossom::draw::add_blsection, blossom::draw::add_bldistance,
          blossom::draw::add_blcheck, blossom::draw::add_blsubdivide, blossom::draw::add_blfillet,
          blossom::draw::add_blchamfer, blossom::draw::add_blblend, blossom::draw::add_blfill,
          blossom::draw::add_blclash})
      add(interpreter);
  }
};

DPLUGIN(BlossomDraw)
