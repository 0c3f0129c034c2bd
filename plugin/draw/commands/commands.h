// SPDX-License-Identifier: LGPL-2.1-or-later
// The commands of Blossom in DRAW, each in the source of its name.

#pragma once

#include <string>

#include "plugin/draw/commands/words.h"

namespace blossom::draw {

struct Command {
  const char* name;
  const char* usage;  ///< its words, for help and for errors
  const char* help;   ///< what follows the usage there
  /// The Tcl result. Throws WrongWords, or says by another exception why there is none.
  std::string (*answer)(const Words& words);
};

extern const Command kBlinfo, kBlintersect, kBltrim, kBlsolid, kBlsection, kBldistance, kBlmass,
    kBlcheck, kBlsubdivide, kBlfillet, kBlchamfer, kBlblend, kBlfill, kBlclash, kBlsew;

}  // namespace blossom::draw
