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
    blossom::draw::add_blintersect(interpreter);
  }
};

DPLUGIN(BlossomDraw)
