// SPDX-License-Identifier: LGPL-2.1-or-later
// The entry of the DRAW plugin: pload -BlossomPlugin BLOSSOM calls Factory once.

#include <string>

#include <Draw_PluginMacro.hxx>

#include "plugin/draw/commands/commands.h"

namespace blossom::draw {
namespace {

template <const Command& kCommand>
int run(Draw_Interpretor& interpreter, int count, const char** words) {
  return answered(interpreter, count, words, kCommand.usage, kCommand.answer);
}

template <const Command&... kCommands>
void add(Draw_Interpretor& interpreter) {
  (interpreter.Add(kCommands.name,
                   (std::string(kCommands.name) + " " + kCommands.usage + kCommands.help).c_str(),
                   ("plugin/draw/commands/" + std::string(kCommands.name) + ".cpp").c_str(),
                   run<kCommands>, "Blossom commands"),
   ...);
}

}  // namespace
}  // namespace blossom::draw

class BlossomDraw {
 public:
  static void Factory(Draw_Interpretor& interpreter) {
    using namespace blossom::draw;
    static bool added = false;
    if (added) return;
    added = true;
    add<kBlinfo, kBlintersect, kBltrim, kBlsolid, kBlsection, kBldistance, kBlmass, kBlcheck,
        kBlsubdivide, kBlfillet, kBlchamfer, kBlblend, kBlfill, kBlclash, kBlsew>(interpreter);
  }
};

DPLUGIN(BlossomDraw)
